#pragma once
// A point of space near a point of interest, known by its heights over all planes of a solid.

#include <groundtruth/definition/expression.hpp>

namespace groundtruth::definition {

struct Sample {
  Heights heights;  // positive multiples of Delta, by leaf, all with one factor per leaf
  Sides sides;

  // The plane of this leaf passes through the sample.
  bool on_plane_of(Leaf leaf) const { return sides[leaf] == 0; }
};

Sample sample_at(const Expression& expression, const Point& point);

// A point at some distance > 0 from `from` in this direction, nearer than any plane that does not pass
// through `from`.
Sample moved(const Expression& expression, const Sample& from, const Triple<Integer>& direction);

}  // namespace groundtruth::definition
