#pragma once
// What stands in asks, answers and scenarios alike. Not installed.

#include <string>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/text/field.hpp>

namespace groundtruth {

WheelState read_state(const Field& field);

// The line's id as JSON; null if it has none. Anything but a string or a number cannot be an id.
std::string id_of(const Json& line);

}  // namespace groundtruth
