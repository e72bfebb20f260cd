#include "step_variants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "borders.hpp"
#include "step_kinds.hpp"
#include "uprightness.hpp"

namespace groundtruth::judge {
namespace {

// The double nearest to the sum, within the range.
double moved(double value, long double change) {
  const long double most = std::numeric_limits<double>::max();
  return static_cast<double>(std::clamp(value + change, -most, most));
}

class Nudged {
 public:
  Nudged(const StepAsk& ask, const StepScales& scales, const Tolerance& tolerance)
      : ask_(ask), scales_(scales), tolerance_(tolerance) {
    if (const auto* contact = std::get_if<Contact>(&ask.state)) sight_ = sight_of(*contact, ask);
  }

  // Every threshold moved so that a contact comes about.
  StepAsk towards_contact() const {
    StepAsk ask = ask_;
    ask.wheel.z_min = moved(ask.wheel.z_min, -of_length());
    ask.wheel.z_max = moved(ask.wheel.z_max, of_length());
    ask.wheel.min_uprightness = more_lenient(ask.wheel.min_uprightness, tolerance_);
    if (auto* contact = std::get_if<Contact>(&ask.state)) {
      if (contact->maximum_force) contact->maximum_force = moved(*contact->maximum_force, of_force());
    }
    return pressed(ask, of_force());
  }
  StepAsk towards_broken() const {
    StepAsk ask = towards_contact();
    ask.wheel.z_min = std::min(moved(ask_.wheel.z_min, of_length()), ask.wheel.z_max);
    return ask;
  }
  StepAsk towards_steep() const {
    StepAsk ask = towards_contact();
    ask.wheel.min_uprightness = stricter(ask_.wheel.min_uprightness, tolerance_);
    return ask;
  }
  StepAsk towards_giving_way() const {
    StepAsk ask = towards_contact();
    auto* contact = std::get_if<Contact>(&ask.state);
    if (contact && contact->maximum_force)
      contact->maximum_force = std::max(0.0, moved(*contact->maximum_force, -2 * of_force()));
    return ask;
  }
  StepAsk towards_end_of_strut() const {
    StepAsk ask = towards_contact();
    ask.wheel.z_max = std::max(moved(ask_.wheel.z_max, -of_length()), ask.wheel.z_min);
    return ask;
  }
  StepAsk towards_lifting_off() const {
    StepAsk ask = towards_contact();
    ask.wheel.z_zero = ask_.wheel.z_zero;
    return pressed(ask, -of_force());
  }

  // The ask with each border around its own; of a free wheel only itself.
  void with_borders(const StepAsk& ask, std::vector<StepAsk>& asks) const {
    asks.push_back(ask);
    const auto* contact = std::get_if<Contact>(&ask.state);
    if (contact == nullptr || !(sight_.pressing > 0)) return;
    const bool sticks = contact->grip == Grip::stick;
    const double friction = sticks ? contact->static_friction : contact->dynamic_friction;
    for (const BorderNumbers& border : borders_around({friction, ask.brake}, sight_.pressing, of_force())) {
      StepAsk nearby = ask;
      auto& moved = std::get<Contact>(nearby.state);
      (sticks ? moved.static_friction : moved.dynamic_friction) = border.friction;
      nearby.brake = border.brake;
      asks.push_back(nearby);
    }
  }

 private:
  long double of_length() const { return tolerance_.relative_decision * scales_.length + scales_.world; }
  long double of_force() const { return tolerance_.relative_decision * scales_.force; }

  // With F'_z changed by this much, by way of z_zero; as it is if F'_z is not that close to 0.
  StepAsk pressed(StepAsk ask, long double change) const {
    const long double n_z = std::fabs(sight_.normal_in_wheel[2]);
    const bool is_close = std::fabs(sight_.pressing) <= 2 * of_force();
    if (!std::holds_alternative<Contact>(ask.state) || !is_close || !(n_z > 0)) return ask;
    ask.wheel.z_zero = moved(ask.wheel.z_zero, change / (std::fabs(ask.wheel.k_z) * n_z));
    return ask;
  }

  const StepAsk& ask_;
  const StepScales& scales_;
  const Tolerance& tolerance_;
  Sight sight_;
};

}  // namespace

std::vector<StepAsk> asks_towards(const StepAnswer& got, const StepAsk& ask, const StepScales& scales,
                                  const Tolerance& tolerance) {
  const Nudged nudged(ask, scales, tolerance);
  std::vector<StepAsk> asks;
  const auto* failure = std::get_if<StepFailure>(&got);
  if (failure && *failure == StepFailure::wheel_broken) {
    nudged.with_borders(nudged.towards_broken(), asks);
  } else if (failure && *failure == StepFailure::surface_too_steep) {
    nudged.with_borders(nudged.towards_steep(), asks);
  } else if (failure) {
    asks.push_back(nudged.towards_giving_way());
  } else if (std::holds_alternative<Refusal>(got) || contact_in(got)) {
    nudged.with_borders(nudged.towards_contact(), asks);
  } else {
    nudged.with_borders(nudged.towards_end_of_strut(), asks);
    asks.push_back(nudged.towards_lifting_off());
  }
  return asks;
}

}  // namespace groundtruth::judge
