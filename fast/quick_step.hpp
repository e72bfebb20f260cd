#pragma once
// A step decided in doubles and computed in double-double, under one bound for the ask. Not installed.

#include <groundtruth/fast/quick_strut.hpp>
#include <groundtruth/fast/quick_touch.hpp>

namespace groundtruth::fast {

template <class Pair>
class QuickStep {
 public:
  QuickStep(const Scene& scene, const StepAsk& ask)
      : scene_(scene), ask_(ask), axes_(ask.frame.world_from_wheel) {}

  // False where a decision or a number is uncertain; `answer` then means nothing.
  bool give(StepAnswer& answer) const {
    if (!is_in_window(axes_.norm_squared().high)) return false;
    const auto* contact = std::get_if<Contact>(&ask_.state);
    return contact ? give_from(*contact, answer) : give_from_free(answer);
  }

 private:
  bool give_from_free(StepAnswer& answer) const {
    const QuickOffset<Pair> at_frame;
    const QuickStrut<Pair> strut(ask_, axes_, at_frame);
    const auto touch = touch_at(strut);
    if (!touch) return false;
    if (touch->kind != QuickTouch::surface) return give_without_landing(*touch, {}, answer);
    Contact& landed = answer.emplace<Stepped>().state.emplace<Contact>();
    touch->write(landed);
    return place_pebble(strut.landing_on(*touch->plane), landed.pebble_in_world);
  }

  bool give_from(const Contact& contact, StepAnswer& answer) const {
    const QuickLoad<Pair> load(ask_, contact, axes_);
    const auto is_extended = reaches(load, ask_.wheel.z_max);
    if (!is_extended) return false;
    if (*is_extended) return give_free({}, answer);
    const auto stands = reaches(load, ask_.wheel.z_min);
    if (!stands) return false;
    if (!*stands) return give_failure(StepFailure::wheel_broken, answer);
    const auto upright = is_upright_in_wheel(contact.normal_in_world);
    if (!upright) return false;
    if (!*upright) return give_failure(StepFailure::surface_too_steep, answer);
    return give_under(contact, load, answer);
  }

  // Is the pebble at least that far down in the wheel? At exactly z_min: uncertain.
  std::optional<bool> reaches(const QuickLoad<Pair>& load, double z) const {
    const double unit = axes_.norm_squared().high, depth = load.depth().high, limit = unit * z;
    return is_at_most(limit, depth,
                      (std::abs(limit) + std::abs(depth)) + (0x1p-40 * (unit * load.arm_size()) + 0x1p-900));
  }

  bool give_under(const Contact& contact, const QuickLoad<Pair>& load, StepAnswer& answer) const {
    const Vector3<Pair> force = load.force();
    const ForceAsk force_ask{contact.normal_in_world,
                             cross_in_doubles(contact.normal_in_world, axes_.rightward_in_doubles()),
                             highs_of(force),
                             load.force_size(),
                             contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction,
                             ask_.brake};
    const SurfaceInDoubles surface(force_ask);
    const double unit = axes_.norm_squared().high;
    if (!surface.is_usable(unit * unit)) return false;
    const auto is_pressed = surface.is_pressed();
    if (!is_pressed) return false;
    if (!*is_pressed) return give_free({}, answer);
    if (contact.maximum_force) {
      const auto holds = surface.holds(*contact.maximum_force);
      if (!holds) return false;
      if (!*holds) return give_failure(StepFailure::surface_gave_way, answer);
    }
    const auto clipping = surface.decide();
    if (!clipping) return false;
    if (*clipping == Clipping::none) return give_stick(contact, force, force_ask.force_size, answer);
    const auto forward = [&] { return cross<Pair>(contact.normal_in_world, axes_.rightward()); };
    const SurfaceInPairs<Pair, Pair, decltype(forward)> in_pairs(force_ask, forward, force);
    return give_slip(contact, load, in_pairs.clipped(*clipping), clip_error(force_ask, surface, *clipping),
                     answer);
  }

  static bool give_stick(const Contact& contact, const Vector3<Pair>& force, double force_size,
                         StepAnswer& answer) {
    Stepped& stepped = answer.emplace<Stepped>();
    Contact& stuck = stepped.state.emplace<Contact>(contact);
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = {};
    return write_opposite(force, 0x1p-90 * force_size, stepped.force_on_frame_in_world);
  }

  bool give_slip(const Contact& contact, const QuickLoad<Pair>& load, const Vector3<Pair>& clipped,
                 double error, StepAnswer& answer) const {
    Vector force_on_frame;
    if (!write_opposite(clipped, error, force_on_frame)) return false;
    const QuickOffset<Pair> offset = relocated(load, clipped, error);
    const QuickStrut<Pair> strut(ask_, axes_, offset);
    const auto touch = touch_at(strut);
    if (!touch) return false;
    if (touch->kind != QuickTouch::surface) return give_without_landing(*touch, force_on_frame, answer);
    Stepped& stepped = answer.emplace<Stepped>();
    stepped.force_on_frame_in_world = force_on_frame;
    Contact& slipped = stepped.state.emplace<Contact>();
    slipped.grip = Grip::slip;
    touch->write(slipped);
    const QuickLanding<Pair> landing = strut.landing_on(*touch->plane);
    return place_pebble(landing, slipped.pebble_in_world) &&
           move_pebble(landing, contact, load, slipped.pebble_velocity_in_world);
  }

  static bool give_failure(StepFailure failure, StepAnswer& answer) {
    answer = failure;
    return true;
  }
  static bool give_free(const Vector& force_on_frame, StepAnswer& answer) {
    answer.emplace<Stepped>().force_on_frame_in_world = force_on_frame;
    return true;
  }
  static bool give_without_landing(const QuickTouch& touch, const Vector& force_on_frame,
                                   StepAnswer& answer) {
    if (touch.kind == QuickTouch::broken) return give_failure(StepFailure::wheel_broken, answer);
    if (touch.kind == QuickTouch::too_steep) return give_failure(StepFailure::surface_too_steep, answer);
    return give_free(force_on_frame, answer);
  }

  // As Load::relocated (step_load.hpp).
  QuickOffset<Pair> relocated(const QuickLoad<Pair>& load, const Vector3<Pair>& clipped, double error) const {
    const double k_xy = ask_.wheel.k_xy, d_xy = ask_.wheel.d_xy, h = ask_.h, force_scale = 0x1p84 * error;
    const bool is_usable = is_in_window(std::abs(k_xy)) && is_in_window(h);
    if (!is_usable) return {{}, std::numeric_limits<double>::infinity()};
    if (ask_.wheel.relocation == Relocation::spring) {
      const double inverse = 1 / k_xy;
      const auto axis = [&](std::size_t k) { return quotient(clipped[k], Pair(k_xy), inverse); };
      return {{axis(0), axis(1), axis(2)}, std::abs(force_scale * inverse)};
    }
    const Pair stiffness = Pair::product(h, k_xy) + Pair(d_xy);
    const double inverse = 1 / stiffness.high;
    const auto axis = [&](std::size_t k) {
      const Pair moved = load.arm()[k] - h * load.velocity()[k];
      return quotient(h * clipped[k] + d_xy * moved, stiffness, inverse);
    };
    const double moved_size = load.arm_size() + h * load.velocity_size();
    return {{axis(0), axis(1), axis(2)}, std::abs((h * force_scale + std::abs(d_xy) * moved_size) * inverse)};
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

  bool place_pebble(const QuickLanding<Pair>& landing, Vector& pebble) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == landing.level_axis) {
        pebble[k] = landing.level;
        continue;
      }
      const double b = ask_.frame.position_in_world[k];
      const Pair& way = landing.from_frame_in_world[k];
      const double error = landing.error + 0x1p-100 * (std::abs(b) + std::abs(way.high));
      const auto place = nearest_double(Pair::loose_sum(b, way), error);
      if (!place) return false;
      pebble[k] = *place;
    }
    return true;
  }

  // From the old place to the new one in a step.
  bool move_pebble(const QuickLanding<Pair>& landing, const Contact& contact, const QuickLoad<Pair>& load,
                   Vector& velocity) const {
    const double h = ask_.h, inverse = 1 / h;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_level = k == landing.level_axis;
      const Pair& to = landing.from_frame_in_world[k];
      const Pair& from = load.arm()[k];
      const Pair moved =
          is_level ? Pair::sum(landing.level, -contact.pebble_in_world[k]) : Pair::loose_sum(to, -from);
      if (is_level && moved.high == 0) {
        velocity[k] = 0;
        continue;
      }
      const double of_ends =
          is_level ? 0 : landing.error + 0x1p-97 * (std::abs(to.high) + std::abs(from.high));
      const double error = of_ends + (0x1p-97 * std::abs(moved.high) + 0x1p-1000);
      const auto speed = nearest_double(quotient(moved, Pair(h), inverse), 2 * (error * inverse));
      if (!speed) return false;
      velocity[k] = *speed;
    }
    return true;
  }

  static bool write_opposite(const Vector3<Pair>& force, double error, Vector& opposite) {
    return round_to_nearest(Vector3<Pair>{-force[0], -force[1], -force[2]}, error, opposite);
  }

  const Scene& scene_;
  const StepAsk& ask_;
  const QuickAxes<Pair> axes_;
};

}  // namespace groundtruth::fast
