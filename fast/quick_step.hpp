#pragma once
// A step decided in doubles and computed in double-double, under one bound for the ask. Not installed.

#include <groundtruth/fast/quick_strut.hpp>
#include <groundtruth/fast/quick_touch.hpp>

namespace groundtruth::fast {

// Nothing where a decision or a number is uncertain.
template <class Pair>
class QuickStep {
 public:
  QuickStep(const Scene& scene, const StepAsk& ask)
      : scene_(scene), ask_(ask), axes_(ask.frame.world_from_wheel) {}

  std::optional<StepAnswer> answer() const {
    if (!is_in_window(axes_.norm_squared().high)) return std::nullopt;
    const auto* contact = std::get_if<Contact>(&ask_.state);
    return contact ? from(*contact) : from_free();
  }

 private:
  std::optional<StepAnswer> from_free() const {
    const QuickOffset<Pair> at_frame;
    const QuickStrut<Pair> strut(ask_, axes_, at_frame);
    const auto touch = touch_at(strut);
    if (!touch) return std::nullopt;
    if (touch->kind != QuickTouch::surface) return without_landing(*touch, {});
    const auto landing = strut.landing_on(*touch->plane);
    const auto pebble = landing ? pebble_at(*landing) : std::nullopt;
    if (!pebble) return std::nullopt;
    return Stepped{touch->contact(Grip::stick, *pebble, {}), {}};
  }

  std::optional<StepAnswer> from(const Contact& contact) const {
    const QuickLoad<Pair> load(ask_, contact, axes_);
    const auto extended = reaches(load, ask_.wheel.z_max);
    if (!extended) return std::nullopt;
    if (*extended) return Stepped{Free{}, {}};
    const auto stands = reaches(load, ask_.wheel.z_min);
    if (!stands) return std::nullopt;
    if (!*stands) return StepFailure::wheel_broken;
    const auto upright = is_upright_in_wheel(contact.normal_in_world);
    if (!upright) return std::nullopt;
    if (!*upright) return StepFailure::surface_too_steep;
    return under(contact, load);
  }

  // Is the pebble at least that far down in the wheel? At exactly z_min: uncertain.
  std::optional<bool> reaches(const QuickLoad<Pair>& load, double z) const {
    const double unit = axes_.norm_squared().high, depth = load.depth().high, limit = unit * z;
    return is_at_most(limit, depth,
                      (std::abs(limit) + std::abs(depth)) + 0x1p-40 * (unit * load.arm_size()));
  }

  std::optional<StepAnswer> under(const Contact& contact, const QuickLoad<Pair>& load) const {
    const double friction =
        contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
    const Vector3<Pair> force = load.force();
    const ForceAsk force_ask{contact.normal_in_world,
                             cross_in_doubles(contact.normal_in_world, axes_.rightward_in_doubles()),
                             highs_of(force),
                             load.force_size(),
                             friction,
                             ask_.brake};
    const SurfaceInDoubles surface(force_ask);
    const double unit = axes_.norm_squared().high;
    if (!surface.is_usable(unit * unit)) return std::nullopt;
    const auto pressed = surface.is_pressed();
    if (!pressed) return std::nullopt;
    if (!*pressed) return Stepped{Free{}, {}};
    if (contact.maximum_force) {
      const auto holds = surface.holds(*contact.maximum_force);
      if (!holds) return std::nullopt;
      if (!*holds) return StepFailure::surface_gave_way;
    }
    const auto clipping = surface.decide();
    if (!clipping) return std::nullopt;
    if (*clipping == Clipping::none) return stick(contact, force, force_ask.force_size);
    const auto forward = [&] { return cross<Pair>(contact.normal_in_world, axes_.rightward()); };
    const SurfaceInPairs<Pair, Pair, decltype(forward)> in_pairs(force_ask, forward, force);
    return slip(contact, load, in_pairs.clipped(*clipping), clip_error(force_ask, surface, *clipping));
  }

  std::optional<StepAnswer> stick(const Contact& contact, const Vector3<Pair>& force, double force_size) const {
    const auto on_pebble = nearest_doubles(force, 0x1p-90 * force_size);
    if (!on_pebble) return std::nullopt;
    Contact stuck = contact;
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = {};
    return Stepped{stuck, opposite(*on_pebble)};
  }

  std::optional<StepAnswer> slip(const Contact& contact, const QuickLoad<Pair>& load, const Vector3<Pair>& clipped,
                                 double error) const {
    const auto on_pebble = nearest_doubles(clipped, error);
    if (!on_pebble) return std::nullopt;
    const auto offset = relocated(load, clipped, error);
    if (!offset) return std::nullopt;
    const QuickStrut<Pair> strut(ask_, axes_, *offset);
    const auto touch = touch_at(strut);
    if (!touch) return std::nullopt;
    if (touch->kind != QuickTouch::surface) return without_landing(*touch, opposite(*on_pebble));
    const auto landing = strut.landing_on(*touch->plane);
    if (!landing) return std::nullopt;
    const auto pebble = pebble_at(*landing);
    const auto velocity = velocity_to(*landing, contact, load);
    if (!pebble || !velocity) return std::nullopt;
    return Stepped{touch->contact(Grip::slip, *pebble, *velocity), opposite(*on_pebble)};
  }

  static StepAnswer without_landing(const QuickTouch& touch, const Vector& force_on_frame) {
    if (touch.kind == QuickTouch::broken) return StepFailure::wheel_broken;
    if (touch.kind == QuickTouch::too_steep) return StepFailure::surface_too_steep;
    return Stepped{Free{}, force_on_frame};
  }

  // As Load::relocated (step_load.hpp).
  std::optional<QuickOffset<Pair>> relocated(const QuickLoad<Pair>& load, const Vector3<Pair>& clipped,
                                             double error) const {
    const double k_xy = ask_.wheel.k_xy, d_xy = ask_.wheel.d_xy, h = ask_.h, force_scale = 0x1p84 * error;
    if (!is_in_window(std::abs(k_xy)) || !is_in_window(h)) return std::nullopt;
    if (ask_.wheel.relocation == Relocation::spring) {
      const double inverse = 1 / k_xy;
      const auto axis = [&](std::size_t k) { return quotient(clipped[k], Pair(k_xy), inverse); };
      return QuickOffset<Pair>{{axis(0), axis(1), axis(2)}, std::abs(force_scale * inverse)};
    }
    const Pair stiffness = Pair::product(h, k_xy) + Pair(d_xy);
    const double inverse = 1 / stiffness.high;
    const auto axis = [&](std::size_t k) {
      const Pair moved = load.arm()[k] - h * load.velocity()[k];
      return quotient(h * clipped[k] + d_xy * moved, stiffness, inverse);
    };
    const double moved_size = load.arm_size() + h * load.velocity_size();
    return QuickOffset<Pair>{{axis(0), axis(1), axis(2)},
                             std::abs((h * force_scale + std::abs(d_xy) * moved_size) * inverse)};
  }

  // Where a contact would be refused, nothing: the reason is for others to give.
  std::optional<QuickTouch> touch_at(const QuickStrut<Pair>& strut) const {
    auto touch = quick_touch(scene_, strut.ends(), ask_.wheel.tyre);
    if (!touch || touch->kind != QuickTouch::surface) return touch;
    const auto upright = is_upright_in_wheel(touch->plane->normal);
    if (!upright || (*upright && !touch->friction)) return std::nullopt;
    if (!*upright) touch->kind = QuickTouch::too_steep;
    return touch;
  }

  std::optional<bool> is_upright_in_wheel(const Vector& normal) const {
    const double unit = axes_.norm_squared().high, n_squared = dot_in_doubles(normal, normal);
    if (!is_in_window(n_squared)) return std::nullopt;
    return is_upright(dot_in_doubles(highs_of(axes_.down()), normal), n_squared * (unit * unit),
                      ask_.wheel.min_uprightness);
  }

  std::optional<Vector> pebble_at(const QuickLanding<Pair>& landing) const {
    Vector pebble;
    for (std::size_t k = 0; k < 3; ++k) {
      if (landing.level && landing.level->axis == k) {
        pebble[k] = landing.level->value + 0.0;
        continue;
      }
      const double b = ask_.frame.position_in_world[k];
      const Pair& way = landing.from_frame_in_world[k];
      const auto place = nearest_double((Pair(b) + way),
                                        landing.error + 0x1p-100 * (std::abs(b) + std::abs(way.high)));
      if (!place) return std::nullopt;
      pebble[k] = *place;
    }
    return pebble;
  }

  // From the old place to the new one in a step.
  std::optional<Vector> velocity_to(const QuickLanding<Pair>& landing, const Contact& contact,
                                    const QuickLoad<Pair>& load) const {
    const double h = ask_.h, inverse = 1 / h;
    Vector velocity;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_level = landing.level && landing.level->axis == k;
      const Pair moved = is_level ? Pair::sum(landing.level->value, -contact.pebble_in_world[k])
                                  : landing.from_frame_in_world[k] - load.arm()[k];
      if (is_level && moved.high == 0) {
        velocity[k] = 0;
        continue;
      }
      const double size = is_level ? 0 : std::abs(landing.from_frame_in_world[k].high) + std::abs(load.arm()[k].high);
      const double error = (is_level ? 0 : landing.error) + 0x1p-97 * (size + std::abs(moved.high));
      const auto speed = nearest_double(quotient(moved, Pair(h), inverse), 2 * (error * inverse));
      if (!speed) return std::nullopt;
      velocity[k] = *speed;
    }
    return velocity;
  }

  static Vector opposite(const Vector& v) { return {-v[0], -v[1], -v[2]}; }

  const Scene& scene_;
  const StepAsk& ask_;
  const QuickAxes<Pair> axes_;
};

}  // namespace groundtruth::fast
