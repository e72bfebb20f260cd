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
  std::optional<MaterialIndex> material;
};
using FaceAlong = std::variant<NoContact, StepFailure, FaceFound>;
std::optional<FaceAlong> face_along(const Scene& scene, const RangeEnds& ends);

// The strut at (x, y) in wheel coordinates.
template <class Real, int n>
class CountedStrut {
 public:
  CountedStrut(const StepAsk& ask, const WorldFromWheel<Real>& world_from_wheel, const Counted<Real, n>& x,
               const Counted<Real, n>& y)
      : ask_(ask),
        world_from_wheel_(world_from_wheel),
        inverse_(counted<Real>(1) / world_from_wheel.norm_squared()),
        x_(x),
        y_(y) {}

  // In doubles.
  RangeEnds ends() const {
    RangeEnds ends;
    place_end(ask_.wheel.z_min, ends.first, ends);
    place_end(ask_.wheel.z_max, ends.last, ends);
    return ends;
  }

  // Where the strut's line meets a plane: the height z over (x, y) follows from m . (x, y, z) = |q|^2 (d - n
  // . b), m being the normal in wheel coordinates times |q|^2.
  Landing<Real, n + 30> landing_on(const HalfSpace& plane) const {
    const auto frame_in_world = counted<Real>(ask_.frame.position_in_world);
    const auto normal_in_wheel = world_from_wheel_.to_wheel(counted<Real>(plane.normal));
    const auto depth = counted<Real>(plane.offset) - dot(counted<Real>(plane.normal), frame_in_world);
    const auto z =
        (depth * world_from_wheel_.norm_squared() - (normal_in_wheel[0] * x_ + normal_in_wheel[1] * y_)) /
        normal_in_wheel[2];
    const auto offset = from_frame(CountedVector<Real, decltype(z)::roundings>{x_, y_, z});
    Landing<Real, n + 30> landing{{}, {}, level_coordinate(plane)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      landing.pebble_in_world[axis] = frame_in_world[axis] + offset[axis];
      landing.from_frame_in_world[axis] = offset[axis];
    }
    if (landing.level) landing.pebble_in_world[landing.level->axis] = counted<Real>(landing.level->value);
    return landing;
  }

 private:
  template <int m>
  CountedVector<Real, m + 12> from_frame(const CountedVector<Real, m>& in_wheel) const {
    const auto longer = world_from_wheel_.to_world(in_wheel);
    return {longer[0] * inverse_, longer[1] * inverse_, longer[2] * inverse_};
  }

  void place_end(double z, Vector& end, RangeEnds& ends) const {
    const auto offset = from_frame(CountedVector<Real, n>{x_, y_, counted<Real>(z)});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto component = counted<Real>(ask_.frame.position_in_world[axis]) + offset[axis];
      end[axis] = static_cast<double>(component.value);
      const double error = component.error() + 0x1p-52 * std::abs(end[axis]);
      if (!(error <= ends.coordinate_error)) ends.coordinate_error = error;  // or if it is not a number
    }
  }

  const StepAsk& ask_;
  const WorldFromWheel<Real>& world_from_wheel_;
  const Counted<Real, 5> inverse_;  // 1 / |q|^2
  const Counted<Real, n> x_;
  const Counted<Real, n> y_;
};

}  // namespace groundtruth::fast
