#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <groundtruth/implementations/answer_session.hpp>

#include "subcommand.hpp"

namespace groundtruth::cli {
namespace {

using implementations::AnswerSession;

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&&) = delete;
  ~File() {
    if (descriptor_ > STDIN_FILENO) close(descriptor_);
  }
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

struct Input {
  std::string place;
  std::filesystem::path folder;  // scene files are relative to it
  File file;
};

struct Options {
  std::string engine = "exact";
  unsigned digits = 0;
  std::vector<std::string> files;
};

// All files are opened before the first answer is written.
std::vector<Input> open_inputs(const std::vector<std::string>& files) {
  std::vector<Input> inputs;
  if (files.empty()) inputs.push_back({"stdin", std::filesystem::current_path(), File(STDIN_FILENO)});
  for (const std::string& file : files) {
    File opened(open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (opened.descriptor() < 0 || std::filesystem::is_directory(file)) {
      throw std::runtime_error(
          file + ": cannot be read: " + std::strerror(opened.descriptor() < 0 ? errno : EISDIR));
    }
    inputs.push_back({file, std::filesystem::path(file).parent_path(), std::move(opened)});
  }
  return inputs;
}

std::size_t read_some(const Input& input, std::string& buffer) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  const std::size_t before = buffer.size();
  buffer.resize(before + chunk);
  ssize_t count = 0;
  do {
    count = read(input.file.descriptor(), buffer.data() + before, chunk);
  } while (count < 0 && errno == EINTR);
  if (count < 0) throw std::runtime_error(input.place + ": cannot be read: " + std::strerror(errno));
  buffer.resize(before + static_cast<std::size_t>(count));
  return static_cast<std::size_t>(count);
}

void write_all(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(STDOUT_FILENO, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw std::runtime_error(std::string("answers cannot be written: ") + std::strerror(errno));
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

// Answers go out whenever what has arrived so far is answered, so that whoever waits for one before asking on
// gets it.
void answer_all(const Input& input, const implementations::Engine& engine) {
  AnswerSession session(engine, input.place, input.folder);
  std::string pending;
  std::string answers;
  const auto answer_line = [&](std::string_view line) {
    if (const auto answer = session.answer(line)) answers += *answer + "\n";
  };
  while (read_some(input, pending) > 0) {
    std::size_t start = 0;
    for (std::size_t end = pending.find('\n'); end != std::string::npos; end = pending.find('\n', start)) {
      answer_line(std::string_view(pending).substr(start, end - start));
      start = end + 1;
    }
    pending.erase(0, start);
    write_all(answers);
    answers.clear();
  }
  if (!pending.empty()) answer_line(pending);
  write_all(answers);
}

Exit run(const Options& options) {
  const auto engine = implementations::make_engine(options.engine, options.digits);
  if (engine == nullptr) {
    fmt::print(stderr, "groundtruth answer: --engine: {} is none of {}, as-written:ERRATUM,...\n",
               options.engine, fmt::join(implementations::engine_names(), ", "));
    return Exit::usage;
  }
  for (const Input& input : open_inputs(options.files)) answer_all(input, *engine);
  return Exit::agrees;
}

}  // namespace

Subcommand add_answer(CLI::App& program) {
  CLI::App* command = program.add_subcommand("answer", "Answers asks, one JSON object a line");
  const auto options = std::make_shared<Options>();
  command->add_option("--engine", options->engine,
                      "exact, definition, fast, double, as-written or as-written:ERRATUM,...");
  command->add_option("--digits", options->digits, "Decimal enclosures of this many digits, from exact")
      ->check(CLI::Range(1U, 10000U));
  command->add_option("files", options->files, "Files of asks; none: standard input");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
