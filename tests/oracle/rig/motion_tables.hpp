#pragma once
// The tables that the command `motion_tables` prints: how well the integrators do, in numbers.

namespace groundtruth::rig {

// Parked on 5 and 10 %, at 0.1 to 10,000 times the stiffness at which explicit integrators give up: what
// became of it, the implicit integrator's iterations, and its time against an explicit step's.
void print_implicit_table();

// Parked on 5 and 10 % for a simulated hour, at every stiffness at which the integrator is stable: how far
// pebbles and bodies went.
void print_drift_table();

// Against closed forms, over h: the acceleration of a slide, and the path of a stop.
void print_slide_and_stop_table();

}  // namespace groundtruth::rig
