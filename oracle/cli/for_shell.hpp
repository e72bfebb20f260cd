#pragma once
// Words as a shell reads them back.

#include <string>

namespace groundtruth::cli {

// The word itself if it is plain, else quoted.
std::string for_shell(const std::string& word);

}  // namespace groundtruth::cli
