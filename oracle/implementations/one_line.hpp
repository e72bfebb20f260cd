#pragma once
// What an implementation says, fit for a message. Private to this folder.

#include <string>
#include <string_view>

namespace groundtruth::implementations {

// Short, and with dots for what is not printable ASCII.
std::string one_line(std::string_view text);

// For the line as it came: only shortened, if it is very long.
std::string shortened(std::string_view text);

}  // namespace groundtruth::implementations
