#pragma once
// A run as a table: a row a step, for other programs to read.

#include <cstdint>
#include <ostream>

#include <groundtruth/rig/simulation.hpp>

namespace groundtruth::report {

// Columns: time, position, velocity, orientation (w, x, y, z), angular velocity, energy; then for each wheel
// its state (free, stick, slip), pebble and the force on the body. World coordinates, SI; numbers read back
// to the same doubles; a free wheel's pebble is empty.
void write_csv_header(std::ostream& out, std::size_t wheels);
void write_csv_row(std::ostream& out, const rig::Moment& moment);

}  // namespace groundtruth::report
