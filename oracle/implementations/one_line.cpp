#include <groundtruth/implementations/one_line.hpp>

#include <algorithm>

namespace groundtruth::implementations {

std::string one_line(std::string_view text) {
  constexpr std::size_t enough = 200;
  std::string line(text.substr(0, enough));
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '.');
  return text.size() > enough ? line + "..." : line;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t enough = std::size_t{1} << 16;
  return std::string(text.substr(0, enough));
}

}  // namespace groundtruth::implementations
