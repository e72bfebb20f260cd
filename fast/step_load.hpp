#pragma once
// A wheel in contact, and the force of its springs, in counted numbers (SPEC section 5). Not installed.

#include <groundtruth/fast/rotation.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::fast {

template <class Real>
CountedVector<Real, 1> differences(const Vector& a, const Vector& b) {
  return {difference<Real>(a[0], b[0]), difference<Real>(a[1], b[1]), difference<Real>(a[2], b[2])};
}

// Vectors are in world coordinates: only the springs' axis is the wheel's (lemma load-without-rotation).
template <class Real>
class Load {
 public:
  Load(const StepAsk& ask, const Contact& contact)
      : ask_(ask),
        contact_(contact),
        axes_(ask.frame.world_from_wheel),
        arm_(differences<Real>(contact.pebble_in_world, ask.frame.position_in_world)),
        depth_(dot(axes_.down(), arm_)) {}

  const StepAsk& ask() const { return ask_; }
  const Contact& contact() const { return contact_; }
  const WheelAxes<Real>& axes() const { return axes_; }
  const CountedVector<Real, 1>& arm() const { return arm_; }  // from the frame to the pebble
  const Counted<Real, 7>& depth() const { return depth_; }    // of the pebble in the wheel, times |q|^2

  // Of the pebble, as the turning frame sees it.
  CountedVector<Real, 4> velocity() const {
    const auto v = differences<Real>(contact_.pebble_velocity_in_world, ask_.frame.velocity_in_world);
    if (ask_.frame.angular_velocity_in_world == Vector{}) return {v[0], v[1], v[2]};
    const auto turning = cross(counted<Real>(ask_.frame.angular_velocity_in_world), arm_);
    return {v[0] - turning[0], v[1] - turning[1], v[2] - turning[2]};
  }

  // Of the springs, on the pebble.
  template <int n>
  auto force(const CountedVector<Real, n>& velocity) const {
    const Wheel& wheel = ask_.wheel;
    const auto& unit = axes_.norm_squared();
    const auto k_xy = counted<Real>(wheel.k_xy), d_xy = counted<Real>(wheel.d_xy);
    const auto along_strut = (difference<Real>(wheel.k_z, wheel.k_xy) * depth_ +
                              difference<Real>(wheel.d_z, wheel.d_xy) * dot(axes_.down(), velocity)) -
                             counted<Real>(wheel.k_z) * counted<Real>(wheel.z_zero) * unit;
    const auto more = along_strut / (unit * unit);
    const auto axis = [&](std::size_t k) {
      return (k_xy * arm_[k] + d_xy * velocity[k]) + more * axes_.down()[k];
    };
    const auto first = axis(0);
    return CountedVector<Real, decltype(first)::roundings>{first, axis(1), axis(2)};
  }

  Grasp<Real, 0> grasp() const {
    const double friction =
        contact_.grip == Grip::stick ? contact_.static_friction : contact_.dynamic_friction;
    return {counted<Real>(contact_.normal_in_world), counted<Real>(friction), counted<Real>(ask_.brake)};
  }

  // Along the surface, across the wheel's y axis.
  CountedVector<Real, 5> forward() const {
    return cross(counted<Real>(contact_.normal_in_world), axes_.rightward());
  }

  // From the frame to where the springs alone, or springs and dampers, give the clipped force: but for a part
  // along the strut.
  template <int n, int m>
  CountedVector<Real, n + 7> relocated(const CountedVector<Real, n>& clipped,
                                       const CountedVector<Real, m>& velocity) const {
    const auto k_xy = counted<Real>(ask_.wheel.k_xy), d_xy = counted<Real>(ask_.wheel.d_xy);
    if (ask_.wheel.relocation == Relocation::spring)
      return {clipped[0] / k_xy, clipped[1] / k_xy, clipped[2] / k_xy};
    const auto h = counted<Real>(ask_.h);
    const auto stiffness = h * k_xy + d_xy;
    const auto axis = [&](std::size_t k) {
      return (h * clipped[k] + d_xy * (arm_[k] - h * velocity[k])) / stiffness;
    };
    return {axis(0), axis(1), axis(2)};
  }

 private:
  const StepAsk& ask_;
  const Contact& contact_;
  const WheelAxes<Real> axes_;
  const CountedVector<Real, 1> arm_;
  const Counted<Real, 7> depth_;
};

}  // namespace groundtruth::fast
