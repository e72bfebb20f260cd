#include <groundtruth/judge/finite.hpp>

#include <algorithm>
#include <cmath>

namespace groundtruth::judge {
namespace {

// Whether every number of an answer is finite, kind by kind.
struct IsFinite {
  bool operator()(double number) const { return std::isfinite(number); }
  bool operator()(const Vector& vector) const { return std::all_of(vector.begin(), vector.end(), *this); }

  bool operator()(const Inside& inside) const { return std::isfinite(inside.lambda); }
  bool operator()(const Border& border) const {
    return std::isfinite(border.lambda) && (*this)(border.normal_in_world);
  }
  bool operator()(const Clipped& clipped) const { return (*this)(clipped.force_in_wheel); }
  bool operator()(const Stepped& stepped) const {
    return (*this)(stepped.force_on_frame_in_world) && std::visit(*this, stepped.state);
  }
  bool operator()(const Contact& contact) const {
    return (*this)(contact.pebble_in_world) && (*this)(contact.pebble_velocity_in_world) &&
           (*this)(contact.normal_in_world) && std::isfinite(contact.static_friction) &&
           std::isfinite(contact.dynamic_friction) && std::isfinite(contact.maximum_force.value_or(0));
  }
  template <typename... Kinds>
  bool operator()(const std::variant<Kinds...>& answer) const {
    return std::visit(*this, answer);
  }
  // What has no numbers.
  bool operator()(const Miss&) const { return true; }
  bool operator()(const TooSteep&) const { return true; }
  bool operator()(const Refusal&) const { return true; }
  bool operator()(const StepFailure&) const { return true; }
  bool operator()(const Free&) const { return true; }
};

}  // namespace

bool has_only_finite_numbers(const Answer& answer) { return IsFinite()(answer); }

}  // namespace groundtruth::judge
