#pragma once
// A step decided in doubles and computed in double-double, under one bound for the ask. Not installed.

#include <groundtruth/fast/quick_pebble.hpp>
#include <groundtruth/fast/quick_touch.hpp>
#include <groundtruth/fast/step_support.hpp>

namespace groundtruth::fast {

template <class Pair>
class QuickStep {
 public:
  using Pairs = Pairs3<Pair>;

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
    QuickTouch touch;
    if (!find_touch(strut, touch)) return false;
    if (touch.kind != QuickTouch::surface) return give_without_landing(touch, {}, answer);
    Contact& landed = answer.emplace<Stepped>().state.emplace<Contact>();
    touch.write(landed);
    return place_pebble(
        ask_.frame.position_in_world, strut.landing_on(touch.plane),
        [&] { return support_of_axes(ask_.frame.world_from_wheel).downward; }, landed.pebble_in_world);
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
    const Pairs force = load.force();
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
    std::optional<StepSupport> known;
    const auto support = [&]() -> const StepSupport& {
      return known ? *known : known.emplace(ask_, contact, force_ask.friction);
    };
    const auto clipping = surface.decide([&] { return support().surface; });
    if (!clipping) return false;
    if (*clipping == Clipping::none)
      return give_stick(contact, {force, 0x1p-90 * force_ask.force_size}, support, answer);
    const auto forward = [&] {
      return cross<Pair>(Doubles3<Pair>(contact.normal_in_world), axes_.rightward());
    };
    const SurfaceInPairs<Pair, Pairs, decltype(forward)> in_pairs(force_ask, forward, force);
    return give_slip(contact, load,
                     {in_pairs.clipped(*clipping), clip_error(force_ask, surface, *clipping), *clipping},
                     support, answer);
  }

  // Of the springs on the pebble, after a clip.
  struct Borne {
    Pairs force;
    double error;
    Clipping clipping = Clipping::none;
  };

  // `support` gives the StepSupport.
  template <class GivesSupport>
  static bool give_stick(const Contact& contact, const Borne& borne, const GivesSupport& support,
                         StepAnswer& answer) {
    Stepped& stepped = answer.emplace<Stepped>();
    Contact& stuck = stepped.state.emplace<Contact>(contact);
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = {};
    return write_opposite(borne, support, stepped.force_on_frame_in_world);
  }

  template <class GivesSupport>
  bool give_slip(const Contact& contact, const QuickLoad<Pair>& load, const Borne& borne,
                 const GivesSupport& support, StepAnswer& answer) const {
    Vector force_on_frame;
    if (!write_opposite(borne, support, force_on_frame)) return false;
    const QuickOffset<Pair> offset = relocated(ask_, load, borne.force, borne.error);
    const QuickStrut<Pair> strut(ask_, axes_, offset);
    QuickTouch touch;
    if (!find_touch(strut, touch)) return false;
    if (touch.kind != QuickTouch::surface) return give_without_landing(touch, force_on_frame, answer);
    Stepped& stepped = answer.emplace<Stepped>();
    stepped.force_on_frame_in_world = force_on_frame;
    Contact& slipped = stepped.state.emplace<Contact>();
    slipped.grip = Grip::slip;
    touch.write(slipped);
    const QuickLanding<Pair> landing = strut.landing_on(touch.plane);
    const auto of_way = [&] { return support().of_way(borne.clipping); };
    const auto of_move = [&] { return support().of_move(borne.clipping); };
    return place_pebble(ask_.frame.position_in_world, landing, of_way, slipped.pebble_in_world) &&
           move_pebble(ask_.h, landing, contact.pebble_in_world, load, of_move,
                       slipped.pebble_velocity_in_world);
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

  // Where a contact would be refused, false: the reason is for others to give.
  bool find_touch(const QuickStrut<Pair>& strut, QuickTouch& touch) const {
    quick_touch(scene_, strut.ends(), ask_.wheel.tyre, touch);
    if (touch.kind != QuickTouch::surface) return touch.kind != QuickTouch::uncertain;
    const auto upright = is_upright_in_wheel(touch.plane.normal);
    if (!upright || (*upright && !touch.friction)) return false;
    if (!*upright) touch.kind = QuickTouch::too_steep;
    return true;
  }

  std::optional<bool> is_upright_in_wheel(const Vector& normal) const {
    const double unit = axes_.norm_squared().high, n_squared = dot_in_doubles(normal, normal);
    if (!is_in_window(n_squared)) return std::nullopt;
    return is_upright(dot_in_doubles(highs_of(axes_.down()), normal), n_squared * (unit * unit),
                      ask_.wheel.min_uprightness);
  }

  template <class GivesSupport>
  static bool write_opposite(const Borne& borne, const GivesSupport& support, Vector& opposite) {
    return round_to_nearest(
        -borne.force, borne.error, [&] { return support().surface.clipped(borne.clipping); }, opposite);
  }

  const Scene& scene_;
  const StepAsk& ask_;
  const QuickAxes<Pair> axes_;
};

}  // namespace groundtruth::fast
