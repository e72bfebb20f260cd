#pragma once
// Where a wheel's strut meets the ground, exactly. Not installed.

#include <optional>
#include <variant>

#include <groundtruth/fast/exact_stage/entry.hpp>
#include <groundtruth/fast/exact_stage/rotation.hpp>
#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/fast/step_contact.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast::exact_stage {

// (x, y) of a strut in wheel coordinates.
struct PlaceInWheel {
  Surd x;
  Surd y;
  Dyadic denominator;  // > 0
  Radicands roots;
};

struct Landing {
  Surface surface;
  SurdVector pebble_in_world;
};

using Touch = std::variant<NoContact, Landing, StepFailure, Refusal>;

// Finds what is left of a scene's solid along a strut: an expression that is met at the same place, with the
// same leaves at it. Valid until the next call.
class Ground {
 public:
  virtual ~Ground() = default;
  virtual ExpressionView along(const RangeEnds& ends) = 0;
};

// What the wheel of the ask finds along its strut, from z_min to z_max: NoContact also where it ends in the
// surface.
Touch touch(const Scene& scene, Ground& ground, const StepAsk& ask, const WorldFromWheel& world_from_wheel,
            const PlaceInWheel& place);

}  // namespace groundtruth::fast::exact_stage
