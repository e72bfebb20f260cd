// Over g++ and clang++, -O0 to -O3, and processors, fast's answers are these bits. tests/fast/bits_table.py
// builds and compares more of them.

#include <gtest/gtest.h>
#include <groundtruth/tests/fast/answer_bits.hpp>

namespace groundtruth {
namespace {

void expect_bits(AskKind kind, std::uint64_t asked, std::uint64_t answered) {
  const Bits bits = bits_of_answers(kind, 400000);
  EXPECT_GT(bits.count, 399000u);
  EXPECT_EQ(bits.asked, asked) << "the asks themselves differ";
  EXPECT_EQ(bits.answered, answered);
}

TEST(FastBits, OfEntryAnswersAreTheSameEverywhere) {
  expect_bits(AskKind::entry, 0xe49182b999faff1f, 0x4451a9007cc1c98c);
}
TEST(FastBits, OfClipAnswersAreTheSameEverywhere) {
  expect_bits(AskKind::clip, 0x3fc881a2f4c2f302, 0xaa906825e508d818);
}
TEST(FastBits, OfStepAnswersAreTheSameEverywhere) {
  expect_bits(AskKind::step, 0x1ac30592130922bb, 0x36281906a5171987);
}

}  // namespace
}  // namespace groundtruth
