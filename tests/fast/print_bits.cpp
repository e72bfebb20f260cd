// fast_bits COUNT: a line a kind of ask: how many, and the bits of asks and of fast's answers.

#include <string>

#include <fmt/core.h>
#include <groundtruth/tests/fast/answer_bits.hpp>

int main(int count, char** arguments) {
  using groundtruth::AskKind;
  if (count != 2) return 2;
  constexpr std::pair<AskKind, const char*> kinds[] = {
      {AskKind::entry, "entry"}, {AskKind::clip, "clip"}, {AskKind::step, "step"}};
  for (const auto& [kind, name] : kinds) {
    const groundtruth::Bits bits = groundtruth::bits_of_answers(kind, std::stoull(arguments[1]));
    fmt::print("{} {} {:016x} {:016x}\n", name, bits.count, bits.asked, bits.answered);
  }
}
