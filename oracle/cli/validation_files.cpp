#include "validation_files.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace groundtruth::cli {
namespace {

[[noreturn]] void refuse(const std::string& file) {
  throw std::runtime_error(file + ": cannot be written: " + std::strerror(errno));
}

}  // namespace

LineFile::LineFile(const std::string& name) : name_(name) {
  if (name.empty()) return;
  file_ = name == "-" ? stdout : std::fopen(name.c_str(), "w");
  if (file_ == nullptr) refuse(name);
}

LineFile::~LineFile() {
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
}

void LineFile::write(std::string_view line) {
  if (file_ == nullptr) return;
  const bool is_written = std::fwrite(line.data(), 1, line.size(), file_) == line.size() &&
                          std::fputc('\n', file_) != EOF && std::fflush(file_) == 0;
  if (!is_written) refuse(name_);
}

void write_text(const std::string& file, std::string_view text) {
  LineFile lines(file);
  lines.write(text.substr(0, text.find_last_not_of('\n') + 1));
}

Exit exit_of(validation::Conclusion conclusion) {
  switch (conclusion) {
    case validation::Conclusion::agrees:
      return Exit::agrees;
    case validation::Conclusion::disagrees:
      return Exit::disagrees;
    case validation::Conclusion::unreadable:
      return Exit::unreadable;
    case validation::Conclusion::broke_down:
      return Exit::broke_down;
    default:
      return Exit::nothing_judged;
  }
}

}  // namespace groundtruth::cli
