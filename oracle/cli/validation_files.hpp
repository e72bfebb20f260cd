#pragma once
// The files that `groundtruth validate` and `groundtruth merge` write, and what they exit with.

#include <cstdio>
#include <string>
#include <string_view>

#include <groundtruth/validation/conclusion.hpp>

#include "subcommand.hpp"

namespace groundtruth::cli {

// A file of lines, each flushed as it is written, so that an abort leaves what was found. Without a name
// it takes lines and keeps none; "-" is standard output.
class LineFile {
 public:
  // Throws if it cannot be written.
  explicit LineFile(const std::string& name);
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;
  ~LineFile();

  void write(std::string_view line);

 private:
  std::string name_;
  std::FILE* file_ = nullptr;
};

// The whole file; throws if it cannot be written.
void write_text(const std::string& file, std::string_view text);

Exit exit_of(validation::Conclusion conclusion);

}  // namespace groundtruth::cli
