#pragma once
// The state of a wheel, which stands in asks, answers and scenarios alike. Not installed.

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/text/json_writer.hpp>

namespace groundtruth {

inline void write_state(JsonWriter& writer, const WheelState& state) {
  writer.open_object();
  if (const auto* contact = std::get_if<Contact>(&state)) {
    writer.member("kind", contact->grip == Grip::stick ? "stick" : "slip");
    writer.member("pebble", contact->pebble_in_world);
    writer.member("velocity", contact->pebble_velocity_in_world);
    writer.member("normal", contact->normal_in_world);
    writer.member("static", contact->static_friction);
    writer.member("dynamic", contact->dynamic_friction);
    writer.member("max_force", contact->maximum_force);
  } else {
    writer.member("kind", "free");
  }
  writer.close_object();
}

}  // namespace groundtruth
