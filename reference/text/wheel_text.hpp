#pragma once
// A wheel inside a larger document: asks, and scenarios.

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/text/field.hpp>
#include <groundtruth/text/json_writer.hpp>

namespace groundtruth {

Wheel read_wheel(const Field& field);
void write_wheel(JsonWriter& writer, const Wheel& wheel);

// A quaternion that is not zero.
Quaternion read_orientation(const Field& field);

}  // namespace groundtruth
