#pragma once
// Some of many witnesses. Private to this folder.

#include <cstddef>
#include <span>
#include <vector>

#include <groundtruth/diagnosis/diagnose.hpp>

namespace groundtruth::diagnosis {

// At most so many, in turns from each kind of ask and of difference between what was got and what is true;
// within a kind those with smaller scenes first, as they are asked about sooner.
std::vector<const Witness*> in_turns(std::span<const Witness> all, std::size_t most);

}  // namespace groundtruth::diagnosis
