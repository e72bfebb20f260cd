#include "command.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace groundtruth::implementations::test {
namespace {

std::string token() { return "hostile-of-" + std::to_string(getpid()); }

// Empty where it cannot be read: a process may end between its listing and its reading, which an iterator
// over the stream's buffer would throw for.
std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

std::vector<std::string> hostile(const std::string& vice) { return {HOSTILE_PROGRAM, vice, token()}; }

std::unique_ptr<Subject> subject(SubjectOrNone found) {
  if (const auto* none = std::get_if<NoSubject>(&found)) throw std::runtime_error(none->problem);
  return std::get<std::unique_ptr<Subject>>(std::move(found));
}

Scene ground() { return {{}, {HalfSpace{{0, 0, 1}, -1}}}; }

std::vector<Ask> asks(std::size_t count, std::size_t poison) {
  std::vector<Ask> all(count, EntryAsk{{0, 0, 1}, {0, 0, 0}});
  if (poison < count) all[poison] = EntryAsk{{0, 0, 666}, {0, 0, 0}};
  return all;
}

std::string kinds(const std::vector<Reply>& replies) {
  std::string letters;
  for (const Reply& reply : replies) letters += "aruch"[static_cast<std::size_t>(reply.kind)];
  return letters;
}

std::vector<std::string> processes_left() {
  std::vector<std::string> left;
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    const std::string line = contents(process.path() / "cmdline");
    if (line.find(token()) != std::string::npos) left.push_back(process.path().filename().string());
  }
  return left;
}

std::size_t open_descriptors() {
  const std::filesystem::directory_iterator open("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(open), end(open)));
}

}  // namespace groundtruth::implementations::test
