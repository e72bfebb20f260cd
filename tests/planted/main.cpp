// planted NAME answers asks as the planted implementation NAME does; planted --list says which there are.

#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include <fmt/core.h>

#include <groundtruth/implementations/answer_session.hpp>

#include "planted_engine.hpp"

namespace groundtruth::planted {
namespace {

void list() {
  for (const RightOne& one : right_ones()) fmt::print("{:30} right {:8} {}\n", one.name, "", one.oddity);
  for (const Bug& bug : all_bugs()) {
    fmt::print("{:30} {:5} {:8} {}\n", bug.name, name(bug.kind), name(bug.reach), bug.mistake);
  }
}

std::optional<RightOne> find(std::string_view name) {
  for (const RightOne& one : right_ones()) {
    if (one.name == name) return one;
  }
  for (const Bug& bug : all_bugs()) {
    if (bug.name == name) return RightOne{bug.name, bug.mistake, bug.on, right_ones().front().rephrase};
  }
  return std::nullopt;
}

// Answers go out whenever the input pauses.
void answer_all(const RightOne& planted) {
  std::ios::sync_with_stdio(false);
  std::cin.tie(nullptr);
  const auto engine = make_engine_of(planted.name, planted.on);
  implementations::AnswerSession session(*engine, "stdin", std::filesystem::current_path());
  for (std::string line; std::getline(std::cin, line);) {
    if (const auto answer = session.answer(line)) std::cout << planted.rephrase(*answer) << '\n';
    if (std::cin.rdbuf()->in_avail() <= 0) std::cout.flush();
  }
  std::cout.flush();
}

}  // namespace
}  // namespace groundtruth::planted

int main(int count, char** arguments) {
  const std::string argument = count == 2 ? arguments[1] : "";
  if (argument == "--list") {
    groundtruth::planted::list();
    return 0;
  }
  const auto planted = groundtruth::planted::find(argument);
  if (!planted) {
    fmt::print(stderr, "planted: '{}' is none of the implementations; planted --list names them\n", argument);
    return 2;
  }
  groundtruth::planted::answer_all(*planted);
  return 0;
}
