#pragma once
// Runs whose end the textbook knows, and how far off they came.

#include <groundtruth/rig/scenario.hpp>
#include <groundtruth/stability/parked.hpp>

namespace groundtruth::rig {

// One wheel, return mapping, 20 rad/s, that can do nothing but settle and slide; slope 0.7 in `slide_error`.
Scenario one_wheel_on_slope(double slope, Integrator integrator, double h);

enum class Body { one_wheel, three_wheels_that_cannot_turn, three_wheels };

// Of the acceleration along the slope against g (sin a - mu_k cos a), relative: over the last 1,000/240 s of
// 4,000/240 s on one wheel; over the last of four seconds of the built-in `slide` on three.
double slide_error(Body body, Integrator integrator, double h);

// The step of `stop_error`: the time to rest is a whole number of steps and a third, or two thirds: whenever
// h is halved, the stop falls as near to a step, in parts of h.
double stop_step(int halvings);

// Of the path to rest from 30 m/s, one settled wheel with h omega = 0.4 that is undamped along the ground,
// against v^2 / (2 mu_k g): m. A damper along the ground would let go up to two steps early: second order
// too, but with a factor that changes with the phase.
double stop_error(Integrator integrator, int halvings);

}  // namespace groundtruth::rig
