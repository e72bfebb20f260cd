#pragma once
// Where a wheel's strut meets the ground, in counted numbers. Not installed.

#include <variant>

#include <groundtruth/fast/paint.hpp>
#include <groundtruth/fast/rotation.hpp>
#include <groundtruth/fast/search.hpp>
#include <groundtruth/fast/step_contact.hpp>

namespace groundtruth::fast {

// The coordinate of every point of a plane that is square to an axis: there it is known without rounding.
struct LevelCoordinate {
  std::size_t axis;
  double value;
};

inline std::optional<LevelCoordinate> level_coordinate(const HalfSpace& plane) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector unit{};
    unit[axis] = 1;
    if (plane.normal == unit) return LevelCoordinate{axis, plane.offset};
    unit[axis] = -1;
    if (plane.normal == unit) return LevelCoordinate{axis, -plane.offset};
  }
  return std::nullopt;
}

// A pebble on a plane.
template <class Real, int n>
struct Landing {
  CountedVector<Real, n> pebble_in_world;
  CountedVector<Real, n> from_frame_in_world;  // its place less the frame's
  std::optional<LevelCoordinate> level;
};

// The first face along a strut that certainly starts outside of the solid and ends in it; or that there is
// none, or that the strut starts inside. Nothing: uncertain.
struct FaceFound {
  Leaf leaf;
  HalfSpace plane;
  std::optional<MaterialIndex> material;
};
using FaceAlong = std::variant<NoContact, StepFailure, FaceFound>;
std::optional<FaceAlong> face_along(const Scene& scene, const RangeEnds& ends);

// The strut through frame + offset, in world coordinates.
template <class Real, int n>
class CountedStrut {
 public:
  CountedStrut(const StepAsk& ask, const WheelAxes<Real>& axes, const CountedVector<Real, n>& offset)
      : ask_(ask), axes_(axes), offset_(offset) {}

  // In doubles.
  RangeEnds ends() const {
    const auto inverse = counted<Real>(1) / axes_.norm_squared();
    const auto depth = dot(axes_.down(), offset_) * inverse;
    RangeEnds ends;
    place_end((counted<Real>(ask_.wheel.z_min) - depth) * inverse, ends.first, ends);
    place_end((counted<Real>(ask_.wheel.z_max) - depth) * inverse, ends.last, ends);
    return ends;
  }

  // Where the strut's line meets a plane: offset + t axis, n . (offset + t axis) = d - n . b.
  Landing<Real, n + 20> landing_on(const HalfSpace& plane) const {
    const auto level = level_coordinate(plane);
    if (level)
      return landing_at(level, (level_height(*level) - offset_[level->axis]) / axes_.down()[level->axis]);
    const auto normal = counted<Real>(plane.normal);
    const auto height =
        (counted<Real>(plane.offset) - dot(normal, counted<Real>(ask_.frame.position_in_world))) -
        dot(normal, offset_);
    return landing_at(level, height / dot(normal, axes_.down()));
  }

 private:
  Counted<Real, 1> level_height(const LevelCoordinate& level) const {
    return difference<Real>(level.value, ask_.frame.position_in_world[level.axis]);
  }

  template <int m>
  Landing<Real, n + 20> landing_at(const std::optional<LevelCoordinate>& level,
                                   const Counted<Real, m>& way) const {
    Landing<Real, n + 20> landing{{}, {}, level};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto from_frame = offset_[axis] + way * axes_.down()[axis];
      landing.from_frame_in_world[axis] = from_frame;
      landing.pebble_in_world[axis] = counted<Real>(ask_.frame.position_in_world[axis]) + from_frame;
    }
    if (level) {
      landing.from_frame_in_world[level->axis] = level_height(*level);
      landing.pebble_in_world[level->axis] = counted<Real>(level->value);
    }
    return landing;
  }

  template <int m>
  void place_end(const Counted<Real, m>& way, Vector& end, RangeEnds& ends) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component =
          counted<Real>(ask_.frame.position_in_world[axis]) + (offset_[axis] + way * axes_.down()[axis]);
      end[axis] = static_cast<double>(component.value);
      const double error = component.error() + 0x1p-52 * std::abs(end[axis]);
      if (!(error <= ends.coordinate_error)) ends.coordinate_error = error;  // or if it is not a number
    }
  }

  const StepAsk& ask_;
  const WheelAxes<Real>& axes_;
  const CountedVector<Real, n>& offset_;
};

}  // namespace groundtruth::fast
