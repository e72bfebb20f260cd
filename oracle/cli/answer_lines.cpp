#include "answer_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <variant>

#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>

namespace groundtruth::cli {

std::vector<std::string> read_lines(const std::string& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) {
    throw std::runtime_error(file + ": cannot be read: " + std::strerror(stream ? EISDIR : errno));
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

AnswerLines::AnswerLines(const std::string& file) {
  const std::vector<std::string> lines = read_lines(file);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool is_hello = std::holds_alternative<HelloLine>(read_line(lines[i], {file, i + 1}));
    if (is_hello && i == 0) continue;
    lines_.push_back({lines[i], i + 1});
    ids_.push_back(read_answer_id(lines[i]));
  }
}

std::optional<AnswerLines::Line> AnswerLines::take(const std::string& id) {
  if (next_ == lines_.size()) return std::nullopt;
  const bool by_order = id == "null" || ids_[next_] == "null" || ids_[next_] == id;
  const auto from = ids_.begin() + static_cast<std::ptrdiff_t>(next_);
  const auto found = by_order ? from : std::find(from, ids_.end(), id);
  if (found == ids_.end()) return std::nullopt;
  passed_over_ += static_cast<std::size_t>(found - from);
  next_ = static_cast<std::size_t>(found - ids_.begin()) + 1;
  return lines_[next_ - 1];
}

}  // namespace groundtruth::cli
