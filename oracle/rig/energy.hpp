#pragma once
// What a machine over its ground could give back.

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/rig/machine.hpp>

namespace groundtruth::rig {

// Kinetic energy, height, and the springs of all wheels, J. Zero height is the world's origin. A wheel that
// has let go of the ground, as damped struts do while they extend, keeps what its strut would be compressed
// by where it stands: `ground` is asked for that. Its tyre is slack. The body is finite.
double energy_of(const Machine& machine, const implementations::EngineOnScene& ground,
                 const MotionState& state, const Controls& controls);

}  // namespace groundtruth::rig
