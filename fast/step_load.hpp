#pragma once
// A wheel in contact, and the force of its springs, in counted numbers (SPEC section 5). Not installed.

#include <groundtruth/fast/rotation.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::fast {

template <class Real>
CountedVector<Real, 1> differences(const Vector& a, const Vector& b) {
  return {difference<Real>(a[0], b[0]), difference<Real>(a[1], b[1]), difference<Real>(a[2], b[2])};
}

// Place, velocity and force in wheel coordinates are times |q|^2.
template <class Real>
class Load {
 public:
  Load(const StepAsk& ask, const Contact& contact)
      : ask_(ask),
        contact_(contact),
        world_from_wheel_(ask.frame.world_from_wheel),
        arm_in_world_(differences<Real>(contact.pebble_in_world, ask.frame.position_in_world)),
        pebble_in_wheel_(world_from_wheel_.to_wheel(arm_in_world_)),
        velocity_in_wheel_(world_from_wheel_.to_wheel(velocity_in_world())) {}

  const StepAsk& ask() const { return ask_; }
  const Contact& contact() const { return contact_; }
  const WorldFromWheel<Real>& world_from_wheel() const { return world_from_wheel_; }
  const CountedVector<Real, 1>& arm_in_world() const { return arm_in_world_; }
  const CountedVector<Real, 7>& pebble_in_wheel() const { return pebble_in_wheel_; }

  // Of the surface, longer than in the world.
  CountedVector<Real, 6> normal_in_wheel() const {
    return world_from_wheel_.to_wheel(counted<Real>(contact_.normal_in_world));
  }

  // Of the springs, on the pebble.
  CountedVector<Real, 12> force_in_wheel() const {
    const Wheel& wheel = ask_.wheel;
    const auto& p = pebble_in_wheel_;
    const auto& w = velocity_in_wheel_;
    const auto k_xy = counted<Real>(wheel.k_xy), d_xy = counted<Real>(wheel.d_xy);
    const auto stretch = p[2] - world_from_wheel_.norm_squared() * counted<Real>(wheel.z_zero);
    return {k_xy * p[0] + d_xy * w[0], k_xy * p[1] + d_xy * w[1],
            counted<Real>(wheel.k_z) * stretch + counted<Real>(wheel.d_z) * w[2]};
  }

  Grasp<Real, 6, 4> grasp() const {
    const double friction =
        contact_.grip == Grip::stick ? contact_.static_friction : contact_.dynamic_friction;
    return {normal_in_wheel(), counted<Real>(friction),
            world_from_wheel_.norm_squared() * counted<Real>(ask_.brake)};
  }

  // Where along an axis of the wheel the springs alone, or springs and dampers, give the clipped force.
  template <int n>
  Counted<Real, n + 12> relocated(const CountedVector<Real, n>& clipped_force, std::size_t axis) const {
    const auto& unit = world_from_wheel_.norm_squared();
    const auto k_xy = counted<Real>(ask_.wheel.k_xy), d_xy = counted<Real>(ask_.wheel.d_xy);
    if (ask_.wheel.relocation == Relocation::spring) return clipped_force[axis] / (unit * k_xy);
    const auto h = counted<Real>(ask_.h);
    const auto damping = d_xy * (pebble_in_wheel_[axis] - h * velocity_in_wheel_[axis]);
    return (h * clipped_force[axis] + damping) / (unit * (h * k_xy + d_xy));
  }

 private:
  // Of the pebble, as the turning frame sees it.
  CountedVector<Real, 4> velocity_in_world() const {
    const auto omega = counted<Real>(ask_.frame.angular_velocity_in_world);
    const auto v = differences<Real>(contact_.pebble_velocity_in_world, ask_.frame.velocity_in_world);
    const auto& arm = arm_in_world_;
    return {v[0] - (omega[1] * arm[2] - omega[2] * arm[1]), v[1] - (omega[2] * arm[0] - omega[0] * arm[2]),
            v[2] - (omega[0] * arm[1] - omega[1] * arm[0])};
  }

  const StepAsk& ask_;
  const Contact& contact_;
  const WorldFromWheel<Real> world_from_wheel_;
  const CountedVector<Real, 1> arm_in_world_;
  const CountedVector<Real, 7> pebble_in_wheel_;
  const CountedVector<Real, 10> velocity_in_wheel_;
};

}  // namespace groundtruth::fast
