#pragma once
// The bits of many of fast's answers as one number, to compare over compilers, flags and processors.

#include <cstdint>

namespace groundtruth {

struct Bits {
  std::uint64_t asked = 0;  // of the asks: if these differ, the answers mean nothing
  std::uint64_t answered = 0;
  std::uint64_t count = 0;
};

enum class AskKind { entry, clip, step };

// About `count` asks of the kind over small, nested, large and far-away scenes.
Bits bits_of_answers(AskKind kind, std::uint64_t count);

}  // namespace groundtruth
