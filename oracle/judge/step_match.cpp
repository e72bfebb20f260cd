#include "step_match.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "direction.hpp"
#include "spread.hpp"
#include "step_kinds.hpp"
#include "wording.hpp"

namespace groundtruth::judge {
namespace {

Verdict wrong(Difference difference, std::string explanation) {
  Verdict verdict;
  verdict.difference = difference;
  verdict.explanation = std::move(explanation);
  return verdict;
}

std::string limit_in_words(const std::optional<double>& limit) {
  return limit ? fmt::format("{}", *limit) : "unlimited";
}

std::string frictions(const Contact& contact) {
  return fmt::format("static {}, dynamic {}, max_force {}", contact.static_friction, contact.dynamic_friction,
                     limit_in_words(contact.maximum_force));
}

Verdict far(const char* quantity, const char* unit, const Vector& got, const Vector& expected,
            double Verdict::*how_far) {
  const auto apart = static_cast<double>(Spread(expected).distance_to(got));
  Verdict verdict = wrong(Difference::numbers, fmt::format("{} {} -> {}: {} {}", quantity, words(got),
                                                           words(expected), short_number(apart), unit));
  if (how_far != nullptr) verdict.*how_far = apart;
  return verdict;
}

}  // namespace

Verdict StepMatch::against(const StepAnswer& got, const StepAnswer& expected) const {
  if (!are_of_one_kind(got, expected)) {
    const bool one_refuses =
        std::holds_alternative<Refusal>(got) || std::holds_alternative<Refusal>(expected);
    return wrong(one_refuses ? Difference::refusal : Difference::state,
                 fmt::format("{} -> {}", kind_in_words(got), kind_in_words(expected)));
  }
  const auto* stepped = std::get_if<Stepped>(&got);
  if (stepped == nullptr) return {};
  if (const Contact* contact = contact_in(got)) {
    const Verdict of_state = of_contacts(*contact, *contact_in(expected));
    if (!of_state.is_accepted()) return of_state;
  }
  const Vector& force = std::get<Stepped>(expected).force_on_frame_in_world;
  const long double apart = Spread(force).distance_to(stepped->force_on_frame_in_world);
  if (apart <= allowed(truth_.tolerance().relative_number, scales_.clipped)) return {};
  return far("force", "N", stepped->force_on_frame_in_world, force, &Verdict::newtons);
}

// A pebble that stays is copied: at most rounded to coarser numbers.
long double StepMatch::kept_slack() const { return truth_.tolerance().metres + scales_.world; }

// Magnified where the strut meets the ground aslant.
long double StepMatch::landing_slack(const Contact& expected) const {
  const Tolerance& tolerance = truth_.tolerance();
  const long double local =
      std::max<long double>(tolerance.metres, allowed(tolerance.relative_number, scales_.landing));
  return (local + scales_.world) * amplification(expected.normal_in_world, ask_.frame);
}

Verdict StepMatch::of_contacts(const Contact& got, const Contact& expected) const {
  const Tolerance& tolerance = truth_.tolerance();
  if (!points_along(got.normal_in_world, expected.normal_in_world, tolerance.normal_angle)) {
    return wrong(Difference::face,
                 fmt::format("normal {} -> {}: {} degrees off", words(got.normal_in_world),
                             words(expected.normal_in_world),
                             short_number(degrees_between(got.normal_in_world, expected.normal_in_world))));
  }
  if (!has_friction_of(got, expected, tolerance.relative_number)) {
    return wrong(Difference::material, fmt::format("{} -> {}", frictions(got), frictions(expected)));
  }
  const long double slack = is_kept(got) ? kept_slack() : landing_slack(expected);
  if (Spread(expected.pebble_in_world).distance_to(got.pebble_in_world) > slack) {
    return far("pebble", "m", got.pebble_in_world, expected.pebble_in_world, &Verdict::metres);
  }
  const long double apart =
      Spread(expected.pebble_velocity_in_world).distance_to(got.pebble_velocity_in_world);
  const bool sticks = got.grip == Grip::stick;
  const long double velocity_slack =
      sticks ? 0 : allowed(tolerance.relative_number, scales_.velocity) + slack / ask_.h;
  if (apart <= velocity_slack) return {};
  return far("velocity", "m/s", got.pebble_velocity_in_world, expected.pebble_velocity_in_world, nullptr);
}

}  // namespace groundtruth::judge
