#pragma once
// The wheel's step (SPEC section 5) in any arithmetic that has roots.

#include <groundtruth/tiers/naive/clip.hpp>
#include <groundtruth/tiers/naive/entry.hpp>

namespace groundtruth::tiers::naive {

// T: wheel coordinates to world coordinates.
template <class Real>
class Placement {
 public:
  explicit Placement(const Frame& frame) : origin_(as<Real>(frame.position_in_world)) {
    const auto [qw, qx, qy, qz] = frame.world_from_wheel;
    const Real w = Real(qw), x = Real(qx), y = Real(qy), z = Real(qz), two = Real(2);
    const Real norm = (w * w + x * x) + (y * y + z * z);
    x_ = {((w * w + x * x) - (y * y + z * z)) / norm, two * (x * y + w * z) / norm,
          two * (x * z - w * y) / norm};
    y_ = {two * (x * y - w * z) / norm, ((w * w + y * y) - (x * x + z * z)) / norm,
          two * (y * z + w * x) / norm};
    z_ = {two * (x * z + w * y) / norm, two * (y * z - w * x) / norm,
          ((w * w + z * z) - (x * x + y * y)) / norm};
  }

  const Vector3<Real>& origin_in_world() const { return origin_; }
  Vector3<Real> world_from_wheel(const Vector3<Real>& v) const {
    return plus(plus(times(v.x, x_), times(v.y, y_)), times(v.z, z_));
  }
  Vector3<Real> wheel_from_world(const Vector3<Real>& v) const {
    return {dot(x_, v), dot(y_, v), dot(z_, v)};
  }

 private:
  Vector3<Real> origin_, x_, y_, z_;
};

template <class Real>
class Step {
 public:
  Step(const Ground<Real>& ground, const StepAsk& ask) : ground_(ground), ask_(ask), placement_(ask.frame) {}

  StepAnswer take() const {
    const auto* contact = std::get_if<Contact>(&ask_.state);
    return contact ? from(*contact) : from_free();
  }

 private:
  struct Landing {
    Contact contact;
    Vector3<Real> pebble_in_world;
  };
  using Touch = std::variant<Free, Landing, StepFailure, Refusal>;

  static StepAnswer no_contact() { return Stepped{Free{}, {}}; }

  static StepAnswer otherwise(const Touch& touch, const Vector& force) {
    if (const auto* failure = std::get_if<StepFailure>(&touch)) return *failure;
    if (const auto* refusal = std::get_if<Refusal>(&touch)) return *refusal;
    return Stepped{Free{}, force};
  }

  bool is_upright_in_wheel(const Vector& normal_in_world) const {
    return is_upright(placement_.wheel_from_world(as<Real>(normal_in_world)),
                      Real(ask_.wheel.min_uprightness));
  }

  // Lowers the wheel at (x, y) in wheel coordinates.
  Touch touch_down(const Real& x, const Real& y) const {
    const auto end = [&](double z) {
      return plus(placement_.origin_in_world(), placement_.world_from_wheel({x, y, Real(z)}));
    };
    const Segment<Real> strut(end(ask_.wheel.z_min), end(ask_.wheel.z_max), Real(0), Real(1));
    const auto found = entered(ground_, strut);
    if (!found || sign_of(Real(found->lambda - Real(1))) == 0) return Free{};
    if (!found->face || sign_of(found->lambda) == 0) return StepFailure::wheel_broken;
    if (!is_upright_in_wheel(found->face->written.normal)) return StepFailure::surface_too_steep;
    return contact_at(*found);
  }

  Touch contact_at(const Entered<Real>& found) const {
    const std::string leaf = "contact: leaf " + std::to_string(found.face->leaf);
    if (!found.material) return Refusal{leaf + " has no material"};
    const Material& material = ground_.materials[*found.material];
    const auto friction = material.friction_by_tyre.find(ask_.wheel.tyre);
    if (friction == material.friction_by_tyre.end())
      return Refusal{leaf + ": material '" + material.name + "' has no friction for '" + ask_.wheel.tyre +
                     "'"};
    if (!is_finite(found.point)) return Refusal{"state.pebble leaves the range of doubles"};
    Contact contact;
    contact.pebble_in_world = rounded(found.point);
    contact.normal_in_world = found.face->written.normal;
    contact.static_friction = friction->second.static_coefficient;
    contact.dynamic_friction = friction->second.dynamic_coefficient;
    contact.maximum_force = material.maximum_force;
    return Landing{contact, found.point};
  }

  StepAnswer from_free() const {
    const Touch touch = touch_down(Real(0), Real(0));
    const auto* landing = std::get_if<Landing>(&touch);
    return landing ? StepAnswer(Stepped{landing->contact, {}}) : otherwise(touch, {});
  }

  StepAnswer from(const Contact& contact) const {
    const Wheel& wheel = ask_.wheel;
    const Vector3<Real> arm = minus(as<Real>(contact.pebble_in_world), placement_.origin_in_world());
    const Vector3<Real> p = placement_.wheel_from_world(arm);
    const Vector3<Real> turning = cross(as<Real>(ask_.frame.angular_velocity_in_world), arm);
    const Vector3<Real> w = placement_.wheel_from_world(minus(
        minus(as<Real>(contact.pebble_velocity_in_world), as<Real>(ask_.frame.velocity_in_world)), turning));
    if (sign_of(Real(p.z - Real(wheel.z_max))) >= 0) return no_contact();
    if (sign_of(Real(p.z - Real(wheel.z_min))) <= 0) return StepFailure::wheel_broken;
    if (!is_upright_in_wheel(contact.normal_in_world)) return StepFailure::surface_too_steep;
    const Real k = Real(wheel.k_xy), d = Real(wheel.d_xy);
    const Vector3<Real> force{k * p.x + d * w.x, k * p.y + d * w.y,
                              Real(wheel.k_z) * (p.z - Real(wheel.z_zero)) + Real(wheel.d_z) * w.z};
    const SurfaceAxes<Real> surface(placement_.wheel_from_world(as<Real>(contact.normal_in_world)));
    const Vector3<Real> on_surface = surface.into(force);
    if (sign_of(on_surface.z) <= 0) return no_contact();
    if (contact.maximum_force && on_surface.z > Real(*contact.maximum_force))
      return StepFailure::surface_gave_way;
    const double friction = contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
    const auto slips = slipping_force(on_surface, Border2<Real>{Real(friction), Real(ask_.brake)});
    return slips ? slide(contact, p, w, surface.out_of(*slips)) : stay(contact, force);
  }

  Vector3<Real> on_frame(const Vector3<Real>& on_pebble_in_wheel) const {
    return times(Real(-1), placement_.world_from_wheel(on_pebble_in_wheel));
  }

  StepAnswer stay(const Contact& contact, const Vector3<Real>& force_in_wheel) const {
    const Vector3<Real> force = on_frame(force_in_wheel);
    if (!is_finite(force)) return Refusal{"force leaves the range of doubles"};
    Contact stuck = contact;
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = {};
    return Stepped{stuck, rounded(force)};
  }

  // x or y of where the pebble goes.
  Real relocated(const Real& clipped, const Real& p, const Real& w) const {
    const Real k = Real(ask_.wheel.k_xy), d = Real(ask_.wheel.d_xy);
    if (ask_.wheel.relocation == Relocation::spring) return clipped / k;
    const Real per_step = d / Real(ask_.h);
    return (clipped + per_step * p - d * w) / (k + per_step);
  }

  StepAnswer slide(const Contact& contact, const Vector3<Real>& p, const Vector3<Real>& w,
                   const Vector3<Real>& clipped) const {
    const Vector3<Real> force = on_frame(clipped);
    if (!is_finite(force)) return Refusal{"force leaves the range of doubles"};
    const Touch touch = touch_down(relocated(clipped.x, p.x, w.x), relocated(clipped.y, p.y, w.y));
    const auto* landing = std::get_if<Landing>(&touch);
    if (!landing) return otherwise(touch, rounded(force));
    const Vector3<Real> moved = minus(landing->pebble_in_world, as<Real>(contact.pebble_in_world));
    const Real h = Real(ask_.h);
    const Vector3<Real> velocity{moved.x / h, moved.y / h, moved.z / h};
    if (!is_finite(velocity)) return Refusal{"state.velocity leaves the range of doubles"};
    Contact slid = landing->contact;
    slid.grip = Grip::slip;
    slid.pebble_velocity_in_world = rounded(velocity);
    return Stepped{slid, rounded(force)};
  }

  const Ground<Real>& ground_;
  const StepAsk& ask_;
  Placement<Real> placement_;
};

template <class Real>
StepAnswer step(const Ground<Real>& ground, const StepAsk& ask) {
  return Step<Real>(ground, ask).take();
}

}  // namespace groundtruth::tiers::naive
