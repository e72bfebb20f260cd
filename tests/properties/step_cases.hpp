#pragma once
// A wheel that is easy to reckon with: upright in a world whose z points down, k = -4 N/m, no damping, z from
// 0 to z_zero = z_max = 2 m. On level ground 1 m down it bears 4 N.

#include <string>

#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {

inline Wheel plain_wheel() {
  Wheel wheel;
  wheel.k_xy = wheel.k_z = -4;
  wheel.z_zero = wheel.z_max = 2;
  wheel.tyre = "rubber";
  return wheel;
}

inline StepAsk plain_step(WheelState state) {
  StepAsk ask;
  ask.wheel = plain_wheel();
  ask.brake = 100;
  ask.h = 0.5;
  ask.state = std::move(state);
  return ask;
}

// Static friction 0.5, dynamic 0.25.
inline Contact contact(Grip grip, const Vector& pebble) {
  return {grip, pebble, {}, {0, 0, -1}, 0.5, 0.25, std::nullopt};
}

// {z >= depth}: level ground of a material of the palette.
inline Shape ground_at(double depth, MaterialIndex material = 0) {
  return covered(material, half_space(0, 0, -1, -depth));
}

// "free", "stick", "slip", "wheel_broken", "surface_too_steep", "surface_gave_way" or "refusal".
inline std::string outcome(const StepAnswer& answer) {
  if (std::holds_alternative<Refusal>(answer)) return "refusal";
  if (const auto* failure = std::get_if<StepFailure>(&answer)) {
    if (*failure == StepFailure::wheel_broken) return "wheel_broken";
    return *failure == StepFailure::surface_too_steep ? "surface_too_steep" : "surface_gave_way";
  }
  const auto* state = std::get_if<Contact>(&std::get<Stepped>(answer).state);
  return !state ? "free" : state->grip == Grip::stick ? "stick" : "slip";
}

inline std::string outcome(const Shape& shape, const StepAsk& ask) {
  return outcome(Ground(shape).step(ask));
}

inline const Contact& contact_of(const StepAnswer& answer) {
  return std::get<Contact>(std::get<Stepped>(answer).state);
}
inline const Vector& force_of(const StepAnswer& answer) {
  return std::get<Stepped>(answer).force_on_frame_in_world;
}

}  // namespace groundtruth::properties
