#pragma once
// A line on the terminal's stderr that says how far a long command is. Nothing is written where stderr is no
// terminal.

#include <cstdint>
#include <string>

namespace groundtruth::cli {

class ProgressBar {
 public:
  ProgressBar();
  void show(const std::string& what, std::uint64_t done, std::uint64_t all);
  void clear();

 private:
  bool on_terminal_;
  int shown_percent_ = -1;
};

}  // namespace groundtruth::cli
