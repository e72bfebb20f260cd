#include <groundtruth/validation/text_file.hpp>

#include <filesystem>
#include <fstream>

#include <groundtruth/text/bad_input.hpp>

namespace groundtruth::validation {

std::vector<std::string> read_text_lines(const std::string& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) throw BadInput(file, 1, "", "cannot be read");
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(std::move(line));
  return lines;
}

}  // namespace groundtruth::validation
