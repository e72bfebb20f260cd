#pragma once
// What the built-in scenarios are made of. Private to this folder. World z is up, and machines head along
// world x.

#include <groundtruth/rig/scenario.hpp>

namespace groundtruth::rig {

inline constexpr double aircraft_mass = 1200;    // kg
inline constexpr double height_of_centre = 1.1;  // m above the ground, with struts just unloaded
inline constexpr double gravity = 9.81;          // m/s^2
inline constexpr double full_brake = 1e6;        // N: beyond any friction of the ground

// Of heave, rad/s. The stiff gear has h omega = 0.4 at h = 1/240 and is made for standing and sliding; the
// soft one sags by 17 mm and takes 6 m/s of sink with a quarter of its travel.
inline constexpr double stiff_gear = 96;
inline constexpr double soft_gear = 24;

// Springs and dampers (damping ratio 0.3) are shared out as the weight is, one fifth to the nose wheel: at
// rest on level ground all struts sag alike. Coordinates of wheels are short binary fractions.
Machine light_aircraft(double heave_frequency);

// One wheel under a body that does not turn.
Machine one_wheel(double heave_frequency);

// Materials of the scenes below.
inline constexpr MaterialIndex dry = 0;
inline constexpr MaterialIndex wet = 1;
inline constexpr MaterialIndex icy = 2;
inline constexpr MaterialIndex soft = 3;  // gives way under 20 kN
Scene scene_of(Shape shape);

// Ground of a material, rising along x, through the origin.
Shape sloping_ground(double rise, MaterialIndex material = dry);
Shape painted(MaterialIndex material, const HalfSpace& where, Shape over);

// The machine's body upright on such ground, its struts just unloaded, moving along it.
BodyState start_on_slope(double rise, double speed = 0);

// On level ground, that far above it, with that sink.
BodyState start_above_ground(double clearance, double speed, double sink);

Signal constant(double value);

// Gravity down, the brake as said, nothing else.
Inputs plain_inputs(double brake);

// By theme; each adds its scenarios.
void add_parked(std::vector<Scenario>& scenarios);
void add_sliding(std::vector<Scenario>& scenarios);
void add_stops(std::vector<Scenario>& scenarios);
void add_landings(std::vector<Scenario>& scenarios);
void add_extremes(std::vector<Scenario>& scenarios);

}  // namespace groundtruth::rig
