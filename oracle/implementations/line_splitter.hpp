#pragma once
// Bytes in, lines out, in bounded memory. Private to this folder.

#include <optional>
#include <string>
#include <string_view>

namespace groundtruth::implementations {

class LineSplitter {
 public:
  static constexpr std::size_t longest_line = std::size_t{1} << 20;

  void add(std::string_view bytes) {
    bytes_.erase(0, start_);
    searched_ -= start_;
    start_ = 0;
    bytes_ += bytes;
  }

  // The next whole line, without its end; valid until add().
  std::optional<std::string_view> next() {
    const std::size_t end = bytes_.find('\n', searched_);
    if (end == std::string::npos) {
      searched_ = bytes_.size();
      return std::nullopt;
    }
    std::string_view line(bytes_.data() + start_, end - start_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    start_ = searched_ = end + 1;
    return line;
  }

  // What has come of a line that has no end yet.
  std::string_view unfinished() const { return std::string_view(bytes_).substr(start_); }
  bool is_too_long() const { return unfinished().size() > longest_line; }

 private:
  std::string bytes_;
  std::size_t start_ = 0;     // of the next line
  std::size_t searched_ = 0;  // no line ends in [start_, searched_)
};

}  // namespace groundtruth::implementations
