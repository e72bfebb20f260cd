#pragma once
// Many failures told as a few: one smallest representative for each cause.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <groundtruth/diagnosis/shrink.hpp>

namespace groundtruth::diagnosis {

struct Failure {
  cases::Case failing;
  std::string kind;  // what is wrong with its answer: "face", "hit/miss", "crashed", ...
};

struct Group {
  std::string kind;
  std::string signature;  // of the representative: "entry intersection(halfspace halfspace)"
  Shrunk representative;
  std::vector<std::string> does_not_matter;  // of its inputs
  std::vector<std::size_t>
      members;  // places in the list of failures; the first was shrunk to the representative
};

struct GroupBudget {
  std::size_t most_groups = 10;
  Budget of_one;
};

// "clip", "step from slip", "entry union(halfspace intersection(halfspace halfspace))": what is left of a
// case when its numbers are left out.
std::string signature_of(const cases::Case& with);

// Failures of one kind whose smallest cases have one signature are one group. Those that were not shrunk, or
// for which there is no room, count with the first group of their kind, so that each failure is a member of
// one group; each kind has a group, even beyond `most_groups`. Largest group first. `still_fail(f)` tells
// which cases fail as failure f does.
std::vector<Group> gather(std::span<const Failure> failures,
                          const std::function<StillFail(const Failure&)>& still_fail,
                          const GroupBudget& budget = {});

}  // namespace groundtruth::diagnosis
