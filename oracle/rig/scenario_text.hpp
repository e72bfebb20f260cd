#pragma once
// Scenarios as text:
//
//   {"groundtruth": "scenario/1", "name": "...", "description": "...",
//    "machine": {"mass": 1200, "inertia": [1000, 1500, 2000] or null (does not turn),
//                "wheels": [{"wheel": {as in asks}, "place": [1.6, 0, 0.3], "brake_share": 1,
//                "steering_share": 0}]},
//    "start": {"position": [...], "orientation": [...], "velocity": [...], "angular_velocity": [...],
//              "wheels": [{"kind": "free"} or as in asks, one a wheel]},
//    "scene": {as in scene files} or "file.json",
//    "inputs": {"brake": input, "steering": input, "thrust": [input, input, input], "push": [...], "gravity":
//    [...]}, "integrator": "semi-implicit" | "half-kick" | "implicit", "h": 0.004, "duration": 10}
//
// An input is a number, or [[time, value], ...], or {"points": number or [[time, value], ...], "amplitude":
// a, "frequency": f}; times do not fall, and two points of one time are a jump. May be absent: name (that of
// the file), description, shares (as shown), velocities (0), states of wheels (free), inputs (0; gravity: [0,
// 0, -9.81]), integrator (as first shown).

#include <filesystem>
#include <string>
#include <string_view>

#include <groundtruth/rig/scenario.hpp>
#include <groundtruth/text/bad_input.hpp>

namespace groundtruth::rig {

// Throws BadInput, which names file, line, field and value, on anything that is not a scenario/1 to the
// letter. Scene files are relative to `folder`.
Scenario read_scenario(std::string_view text, const Origin& origin, const std::filesystem::path& folder);

// Throws BadInput also if there is no such file.
Scenario read_scenario_file(const std::string& file);

// One line of JSON, with the scene in it, that reads back to the same scenario, bit for bit but for -0.
std::string write_scenario(const Scenario& scenario);

// Can so many steps be counted? Requires h > 0, duration >= 0.
inline bool is_countable(double duration, double h) { return duration / h <= 0x1p53; }

}  // namespace groundtruth::rig
