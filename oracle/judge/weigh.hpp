#pragma once
// One weighing room a kind of ask. Each finds the first thing in which an answer is wrong; the verdict's
// exact answer is the caller's to fill in. Private to this folder.

#include <groundtruth/judge/verdict.hpp>

#include "truth.hpp"

namespace groundtruth::judge {

Verdict weigh_entry(const Truth& truth, const EntryAsk& ask, const EntryAnswer& got, const Answered& exact);
Verdict weigh_clip(const Truth& truth, const ClipAsk& ask, const ClipAnswer& got, const Answered& exact);
Verdict weigh_step(const Truth& truth, const StepAsk& ask, const StepAnswer& got, const Answered& exact);

}  // namespace groundtruth::judge
