#pragma once
// The lines of a file of answers, each to be found by the ask that it answers.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace groundtruth::cli {

// Throws if the file cannot be read.
std::vector<std::string> read_lines(const std::string& file);

class AnswerLines {
 public:
  explicit AnswerLines(const std::string& file);

  struct Line {
    std::string text;
    std::size_t number = 0;  // in the file, from 1
  };

  // The next line if it bears this id; else the first later one that does, and those before it answer
  // nothing; absent if there is none. An id of null, or a line without a readable one, goes by order alone.
  std::optional<Line> take(const std::string& id);

  // How many lines answer nothing that was asked.
  std::size_t left_over() const { return passed_over_ + (lines_.size() - next_); }

 private:
  std::vector<Line> lines_;
  std::vector<std::string> ids_;
  std::size_t next_ = 0;
  std::size_t passed_over_ = 0;
};

}  // namespace groundtruth::cli
