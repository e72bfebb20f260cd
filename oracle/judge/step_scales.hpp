#pragma once
// The size of what enters a step's numbers. Private to this folder; derivation: proofs-notes/tolerance.md, 3.

#include <groundtruth/problem/ask.hpp>

namespace groundtruth::judge {

// Sums of magnitudes of terms; a hair of rounding in them does not matter. Long doubles, so that none leaves
// the range. All but `world` are local: the contact is seen from the frame, so that none grows with the
// distance from the world's origin.
struct StepScales {
  long double force = 0;      // N: of the springs' force
  long double clipped = 0;    // N: of what is left of it: mu times the normal force's terms are in it
  long double length = 0;     // m: of p and of the strut
  long double landing = 0;    // m: of where the strut goes
  long double stiffness = 1;  // N/m: a landing moves by a force divided by it
  long double velocity = 0;   // m/s: of a slipping pebble: max(|w|, |p| / h)
  long double world = 0;      // m: what a few roundings cost of a place in world coordinates
};

StepScales scales_of(const StepAsk& ask);

// The contact as the wheel sees it, in long doubles: what the tolerance's asks are chosen by, never what an
// answer is judged by.
struct Sight {
  std::array<long double, 3> pebble_in_wheel{};
  std::array<long double, 3> normal_in_wheel{};  // of unit length
  long double pressing = 0;                      // F'_z, N
};

Sight sight_of(const Contact& contact, const StepAsk& ask);

// How much farther than the ground moves, the point moves where the strut meets it: ||n|| / |n_z|.
long double amplification(const Vector& normal_in_world, const Frame& frame);

}  // namespace groundtruth::judge
