#pragma once
// The first point of a segment that is a member of a solid: of the start and of all points where the segment
// crosses a leaf's plane, in ascending order, the first that is a member.

#include <optional>

#include <groundtruth/definition/expression.hpp>

namespace groundtruth::definition {

// From first / weight to last / weight.
struct Segment {
  Triple<Whole> first, last;
  Integer weight;
};
Segment segment_between(const Triple<Real>& first, const Triple<Real>& last);

// The place theta = numerator / denominator in [0, 1] of a segment, denominator > 0.
struct Moment {
  Whole numerator = 0;
  Integer denominator = 1;

  bool is_start() const { return numerator.sign() == 0; }
  bool is_end() const { return (numerator - Whole(denominator)).sign() == 0; }
};

// first + theta (last - first)
Point point_at(const Segment& segment, const Moment& moment);

std::optional<Moment> first_member(const Expression& expression, const Segment& segment);

}  // namespace groundtruth::definition
