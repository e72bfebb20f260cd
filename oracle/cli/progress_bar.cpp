#include "progress_bar.hpp"

#include <unistd.h>

#include <fmt/core.h>

namespace groundtruth::cli {

ProgressBar::ProgressBar() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const std::string& what, std::uint64_t done, std::uint64_t all) {
  const int percent = all == 0 ? 100 : static_cast<int>(100 * done / all);
  if (!on_terminal_ || percent == shown_percent_) return;
  shown_percent_ = percent;
  constexpr int width = 40;
  const int filled = width * percent / 100;
  fmt::print(stderr, "\r{:<12} [{:=<{}}{:<{}}] {:>3} %", what, "", filled, "", width - filled, percent);
}

void ProgressBar::clear() {
  if (on_terminal_ && shown_percent_ >= 0) fmt::print(stderr, "\r{:<70}\r", "");
  shown_percent_ = -1;
}

}  // namespace groundtruth::cli
