#pragma once
// An answer on a border, looked at closely.

#include <vector>

#include "right.hpp"

namespace groundtruth::planted {

class Meeting {
 public:
  Meeting(const Right& right, const EntryAsk& ask, const Border& border);

  const Right& right;
  const EntryAsk& ask;
  const Border& border;          // the right answer
  std::vector<Leaf> admissible;  // ascending
  Place point;                   // x(lambda*)
  bool at_start;                 // lambda* = lambda_first

  // The leaves whose planes hold the point, admissible or not.
  std::vector<Leaf> tied() const;
  bool is_admissible(Leaf leaf) const;
  const HalfSpace& half_space(Leaf leaf) const { return right.leaves()[leaf].half_space; }
  // n . (to - from): negative where the leaf is entered.
  double advance(Leaf leaf) const;
  // The answer with another leaf, and that leaf's material.
  Border on(Leaf leaf) const;
};

// The number of distinct planes among the leaves, told apart by their normals' directions.
std::size_t planes_among(const Meeting& meeting, const std::vector<Leaf>& leaves);

}  // namespace groundtruth::planted
