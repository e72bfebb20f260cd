#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string_view>

#include <groundtruth/implementations/groundtruth_implementation.h>
#include <groundtruth/implementations/line_splitter.hpp>
#include <groundtruth/implementations/piped_subject.hpp>

namespace groundtruth::implementations {
namespace {

using AnswerFunction = decltype(&groundtruth_answer);

void write_line(int file, std::string line) {
  line += '\n';
  for (std::string_view left = line; !left.empty();) {
    const ssize_t count = write(file, left.data(), left.size());
    if (count < 0) _exit(0);  // nobody listens any more
    left.remove_prefix(static_cast<std::size_t>(count));
  }
}

[[noreturn]] void answer_lines(AnswerFunction answer, int answers) {
  LineSplitter lines;
  std::array<char, std::size_t{1} << 16> bytes;
  for (ssize_t count = 0; (count = read(STDIN_FILENO, bytes.data(), bytes.size())) > 0;) {
    lines.add({bytes.data(), static_cast<std::size_t>(count)});
    while (const auto line = lines.next()) {
      if (const char* text = answer(std::string(*line).c_str())) write_line(answers, text);
    }
  }
  _exit(0);
}

// Runs in a process of its own. What the library prints goes to standard error, as it is no answer.
std::string serve_library(const std::string& path) {
  const int answers = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return dlerror();
  void* function = dlsym(library, "groundtruth_answer");
  if (function == nullptr) return path + ": it has no function groundtruth_answer";
  close(status_in_child);
  answer_lines(reinterpret_cast<AnswerFunction>(function), answers);
}

}  // namespace

SubjectOrNone load_library(const std::string& path, const Patience& patience) {
  // Without a slash the dynamic linker would look elsewhere only.
  const bool is_here = std::filesystem::exists(path);
  const std::string found = is_here ? std::filesystem::absolute(path).string() : path;
  return piped_subject([found] { return serve_library(found); }, patience);
}

}  // namespace groundtruth::implementations
