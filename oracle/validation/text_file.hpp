#pragma once
// Files of lines.

#include <string>
#include <vector>

namespace groundtruth::validation {

// Without line ends; throws BadInput if it cannot be read.
std::vector<std::string> read_text_lines(const std::string& file);

}  // namespace groundtruth::validation
