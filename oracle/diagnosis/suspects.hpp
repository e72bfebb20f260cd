#pragma once
// Errors that an implementation may have made, each as something that answers with it.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::diagnosis {

// What it takes to be the same error (resemblance.hpp).
enum class Trace { own_error, rounding };

struct Suspect {
  std::string name;         // "single-pass-intersection", "ignored-range", ...
  std::string explanation;  // one line
  std::function<Answer(const Scene&, const Ask&)> answer;
  Trace trace = Trace::own_error;
};

// The errata of SPEC section 7, each alone.
std::vector<Suspect> errata();

// Each two of them together.
std::vector<Suspect> pairs_of_errata();

// What else people get wrong: a small change to ask, scene or answer around the exact engine, and plain
// doubles.
std::vector<Suspect> classic_slips();

}  // namespace groundtruth::diagnosis
