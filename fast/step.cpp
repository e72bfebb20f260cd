#include <groundtruth/fast/step.hpp>

#include <groundtruth/fast/exact_stage/step.hpp>
#include <groundtruth/fast/step_decided.hpp>
#include <groundtruth/fast/step_ground.hpp>
#include <groundtruth/fast/step_strut.hpp>

namespace groundtruth::fast {

namespace {

// A step in counted numbers. Whatever returns nothing is uncertain.
template <class Real>
class Stepper {
 public:
  Stepper(const Scene& scene, const StepAsk& ask)
      : scene_(scene), ask_(ask), world_from_wheel_(ask.frame.world_from_wheel) {}

  std::optional<StepAnswer> from_free() const {
    const Counted<Real, 0> zero;
    const auto touch = CountedStrut(ask_, world_from_wheel_, zero, zero).touch(scene_);
    if (!touch) return std::nullopt;
    if (const auto* failure = std::get_if<StepFailure>(&*touch)) return *failure;
    if (const auto* refusal = std::get_if<Refusal>(&*touch)) return *refusal;
    if (std::holds_alternative<NoContact>(*touch)) return Stepped{Free{}, {}};
    const auto& landing = std::get<1>(*touch);
    const auto pebble = nearest_doubles(landing.pebble_in_world);
    if (!pebble) return std::nullopt;
    return Stepped{landing.surface.contact(Grip::stick, *pebble, {}), {}};
  }

  std::optional<StepAnswer> from(const Contact& contact) const {
    const Wheel& wheel = ask_.wheel;
    const auto& unit = world_from_wheel_.norm_squared();  // p, w and the force are in 1/unit
    const auto arm = arm_in_world(contact);
    const auto p = world_from_wheel_.to_wheel(arm);
    const auto extended = is_at_most(unit * counted<Real>(wheel.z_max), p[2]);
    if (!extended) return std::nullopt;
    if (*extended) return Stepped{Free{}, {}};
    const auto compressed = is_at_most(p[2], unit * counted<Real>(wheel.z_min));
    if (!compressed) return std::nullopt;
    if (*compressed) return StepFailure::wheel_broken;
    const auto n = world_from_wheel_.to_wheel(counted<Real>(contact.normal_in_world));
    const auto upright = is_upright(n, wheel.min_uprightness);
    if (!upright) return std::nullopt;
    if (!*upright) return StepFailure::surface_too_steep;
    return under_load(contact, arm,
                      PebbleInWheel{p, world_from_wheel_.to_wheel(velocity_in_world(contact, arm))}, n);
  }

 private:
  // Times |q|^2.
  struct PebbleInWheel {
    CountedVector<Real, 7> place;
    CountedVector<Real, 10> velocity;
  };

  CountedVector<Real, 1> arm_in_world(const Contact& contact) const {
    return differences(contact.pebble_in_world, ask_.frame.position_in_world);
  }
  static CountedVector<Real, 1> differences(const Vector& a, const Vector& b) {
    return {difference<Real>(a[0], b[0]), difference<Real>(a[1], b[1]), difference<Real>(a[2], b[2])};
  }

  // Of the pebble against the frame, as the frame sees it.
  CountedVector<Real, 4> velocity_in_world(const Contact& contact, const CountedVector<Real, 1>& arm) const {
    const auto omega = counted<Real>(ask_.frame.angular_velocity_in_world);
    const auto v = differences(contact.pebble_velocity_in_world, ask_.frame.velocity_in_world);
    return {v[0] - (omega[1] * arm[2] - omega[2] * arm[1]), v[1] - (omega[2] * arm[0] - omega[0] * arm[2]),
            v[2] - (omega[0] * arm[1] - omega[1] * arm[0])};
  }

  // On the pebble, times |q|^2.
  CountedVector<Real, 12> spring_force(const PebbleInWheel& pebble) const {
    const Wheel& wheel = ask_.wheel;
    const auto& [p, w] = pebble;
    const auto k_xy = counted<Real>(wheel.k_xy), k_z = counted<Real>(wheel.k_z);
    const auto d_xy = counted<Real>(wheel.d_xy), d_z = counted<Real>(wheel.d_z);
    const auto stretch = p[2] - world_from_wheel_.norm_squared() * counted<Real>(wheel.z_zero);
    return {k_xy * p[0] + d_xy * w[0], k_xy * p[1] + d_xy * w[1], k_z * stretch + d_z * w[2]};
  }

  std::optional<StepAnswer> under_load(const Contact& contact, const CountedVector<Real, 1>& arm,
                                       const PebbleInWheel& pebble, const CountedVector<Real, 6>& n) const {
    const auto& unit = world_from_wheel_.norm_squared();
    const auto force = spring_force(pebble);
    const auto pressing = -dot(n, force);  // F'_z |n| |q|^2
    const Sign pressed = sign_of(pressing);
    if (pressed == Sign::uncertain) return std::nullopt;
    if (pressed != Sign::positive) return Stepped{Free{}, {}};
    if (contact.maximum_force) {
      const auto holds =
          is_at_most(square(pressing), square(unit * counted<Real>(*contact.maximum_force)) * dot(n, n));
      if (!holds) return std::nullopt;
      if (!*holds) return StepFailure::surface_gave_way;
    }
    const double friction = contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
    const Grasp<Real, 6, 4> grasp{n, counted<Real>(friction), unit * counted<Real>(ask_.brake)};
    return ForceOnSurface(grasp, force)
        .clip([&](Grip grip, const auto& clipped) -> std::optional<StepAnswer> {
          if (grip == Grip::slip) return slip(contact, arm, pebble, clipped);
          Contact stuck = contact;
          stuck.grip = Grip::stick;
          stuck.pebble_velocity_in_world = {};
          return answer_with(stuck, clipped);
        });
  }

  // Where the springs alone, or springs and dampers, give the clipped force.
  template <int n>
  Counted<Real, n + 12> relocated(const PebbleInWheel& pebble, const CountedVector<Real, n>& force,
                                  std::size_t axis) const {
    const auto& unit = world_from_wheel_.norm_squared();
    const auto k_xy = counted<Real>(ask_.wheel.k_xy), d_xy = counted<Real>(ask_.wheel.d_xy);
    if (ask_.wheel.relocation == Relocation::spring) return force[axis] / (unit * k_xy);
    const auto h = counted<Real>(ask_.h);
    const auto damping = d_xy * (pebble.place[axis] - h * pebble.velocity[axis]);
    return (h * force[axis] + damping) / (unit * (h * k_xy + d_xy));
  }

  template <int n>
  std::optional<StepAnswer> slip(const Contact& contact, const CountedVector<Real, 1>& arm,
                                 const PebbleInWheel& pebble, const CountedVector<Real, n>& clipped) const {
    const auto x = relocated(pebble, clipped, 0), y = relocated(pebble, clipped, 1);
    const auto touch = CountedStrut(ask_, world_from_wheel_, x, y).touch(scene_);
    if (!touch) return std::nullopt;
    if (const auto* failure = std::get_if<StepFailure>(&*touch)) return *failure;
    if (const auto* refusal = std::get_if<Refusal>(&*touch)) return *refusal;
    if (std::holds_alternative<NoContact>(*touch)) return answer_with(Free{}, clipped);
    const auto& landing = std::get<1>(*touch);
    const auto new_pebble = nearest_doubles(landing.pebble_in_world);
    const auto velocity = nearest_doubles(velocity_of(landing, arm, contact));
    if (!new_pebble || !velocity) return std::nullopt;
    return answer_with(landing.surface.contact(Grip::slip, *new_pebble, *velocity), clipped);
  }

  template <int n>
  auto velocity_of(const CountedLanding<Real, n>& landing, const CountedVector<Real, 1>& arm,
                   const Contact& contact) const {
    const auto h = counted<Real>(ask_.h);
    CountedVector<Real, n + 3> velocity;
    for (std::size_t axis = 0; axis < 3; ++axis)
      velocity[axis] = (landing.from_frame_in_world[axis] - arm[axis]) / h;
    if (const auto& level = landing.level)
      velocity[level->axis] = difference<Real>(level->value, contact.pebble_in_world[level->axis]) / h;
    return velocity;
  }

  // With the opposite force on the frame.
  template <int n>
  std::optional<StepAnswer> answer_with(const WheelState& state,
                                        const CountedVector<Real, n>& force_in_wheel) const {
    const auto inverse = counted<Real>(-1) / square(world_from_wheel_.norm_squared());
    const auto in_world = world_from_wheel_.to_world(force_in_wheel);
    const auto force = nearest_doubles(
        CountedVector<Real, n + 16>{in_world[0] * inverse, in_world[1] * inverse, in_world[2] * inverse});
    if (!force) return std::nullopt;
    return Stepped{state, *force};
  }

  const Scene& scene_;
  const StepAsk& ask_;
  const WorldFromWheel<Real> world_from_wheel_;
};

template <class Real>
std::optional<StepAnswer> try_step(const Scene& scene, const StepAsk& ask) {
  const Stepper<Real> stepper(scene, ask);
  const auto* contact = std::get_if<Contact>(&ask.state);
  return contact ? stepper.from(*contact) : stepper.from_free();
}

}  // namespace

DecidedStep decide_step(const Scene& scene, const StepAsk& ask) {
  if (const auto answer = try_step<Extended>(scene, ask)) return {*answer, Stage::extended};
  if (const auto answer = try_step<Pair>(scene, ask)) return {*answer, Stage::double_pair};
  SolidAlongStrut ground(scene);
  return {exact_stage::step(scene, ground, ask), Stage::exact};
}

StepAnswer step(const Scene& scene, const StepAsk& ask) { return decide_step(scene, ask).answer; }

}  // namespace groundtruth::fast
