#pragma once
// How malformed text is refused: one line that names the place, the field and the value.

#include <cstddef>
#include <stdexcept>
#include <string>

namespace groundtruth {

// what() reads "PLACE:LINE: FIELD: PROBLEM"; the field is left out where the text is no JSON at all.
class BadInput : public std::runtime_error {
 public:
  BadInput(const std::string& place, std::size_t line, const std::string& field, const std::string& problem)
      : std::runtime_error(place + ":" + std::to_string(line) + ": " + (field.empty() ? "" : field + ": ") +
                           problem) {}
};

// Where a text came from: a file's name, or "stdin", and the number of its first line.
struct Origin {
  std::string place;
  std::size_t first_line = 1;
};

}  // namespace groundtruth
