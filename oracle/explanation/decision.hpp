#pragma once
// Where a segment first enters a solid, from its breakpoints; and how near another decision is.

#include <optional>
#include <string>
#include <vector>

#include <groundtruth/explanation/faces.hpp>

namespace groundtruth::explanation {

// x(lambda) = from + lambda direction, lambda in [first, last].
struct Segment {
  RationalVector from;
  RationalVector direction;
  Rational first = 0;
  Rational last = 1;

  RationalVector at(const Rational& lambda) const { return along(from, lambda, direction); }
};

// first, last, and every lambda between them at which a plane is crossed; ascending.
std::vector<Rational> breakpoints_of(const Solid& solid, const Segment& segment);

// Which half-spaces hold x(lambda), by place.
std::vector<bool> truth_at(const Solid& solid, const Segment& segment, const Rational& lambda);

struct Decision {
  std::optional<Rational> lambda;        // absent: a miss
  Meeting meeting;                       // at x(lambda)
  std::optional<std::size_t> canonical;  // the face's place; absent on a miss and inside

  bool is_inside() const { return lambda.has_value() && !canonical.has_value(); }
};

Decision decision_on(const Solid& solid, const Segment& segment);

enum class Flips { hit_or_miss, face };

// The smallest change of one leaf's offset that changes the decision.
struct Flip {
  Flips what = Flips::face;
  std::size_t plane = 0;
  Rational offset_change;   // what is added to d, in the units of the leaf as written
  int side = 1;             // outwards (+1) or inwards (-1), where the change is zero
  bool is_reached = false;  // at this change; else as soon as it is passed
  Rational metres_squared;  // how far the plane moves
  Decision becomes;
};

struct Search {
  std::vector<Flip> flips;  // at most one of each kind
  std::size_t tried = 0;    // decisions taken
  bool is_complete = true;  // else it stopped at its limit, and what is nearer than the flips is excluded
};

// By the distance that the plane moves, nearest first. Changes that move a plane by more than
// sqrt(reach_squared) metres are not looked at.
Search nearest_flips(const Solid& solid, const Segment& segment, const Rational& reach_squared);

}  // namespace groundtruth::explanation
