#pragma once
// Frames, the spring law and the answers' rounding for the wheel's step. Private to this folder.

#include <groundtruth/exact/arithmetic/root_sum.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::exact {

// The rotation v -> q v q^-1 of a quaternion that need not be normalised; its entries are rational.
class Rotation {
 public:
  explicit Rotation(const Quaternion& q);

  RationalVector operator()(const RationalVector& vector) const;
  RationalVector inverse(const RationalVector& vector) const;

 private:
  std::array<RationalVector, 3> rows_;
};

// T_{b,q}.
struct Placement {
  RationalVector origin_in_world;
  Rotation world_from_wheel;

  explicit Placement(const Frame& frame)
      : origin_in_world(to_rational(frame.position_in_world)), world_from_wheel(frame.world_from_wheel) {}
  RationalVector to_world(const RationalVector& point_in_wheel) const {
    return origin_in_world + world_from_wheel(point_in_wheel);
  }
  RationalVector to_wheel(const RationalVector& point_in_world) const {
    return world_from_wheel.inverse(point_in_world - origin_in_world);
  }
};

// A contact as the wheel sees it.
struct ContactInWheel {
  RationalVector pebble;
  RationalVector pebble_velocity;  // relative to the frame, turning with it
  RationalVector normal;
};

ContactInWheel seen_from_wheel(const Contact& contact, const Frame& frame, const Placement& placement);

// The springs' force on the pebble, in the wheel frame (SPEC section 5).
RationalVector spring_force(const Wheel& wheel, const ContactInWheel& contact);

// Where the clipped force puts a slipping pebble: x and y in the wheel frame, and z = z_min.
RootVector relocated(const Wheel& wheel, const ContactInWheel& contact,
                     const RootVector& clipped_force_in_wheel, const Rational& h);

}  // namespace groundtruth::exact
