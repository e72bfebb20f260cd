#include <groundtruth/fast/large_vector.hpp>

#include <cstdint>

#include <gtest/gtest.h>

namespace groundtruth::fast {
namespace {

TEST(LargeVectors, KeepWhatTheyHoldWhenTheyBecomeLarge) {
  LargeVector<std::uint64_t> numbers;
  for (std::uint64_t i = 0; i < (4 * large_page) / sizeof i; ++i) numbers.push_back(i);
  const LargeVector<std::uint64_t> copy = numbers;
  numbers.resize(10);
  numbers.shrink_to_fit();
  for (std::uint64_t i = 0; i < copy.size(); ++i) ASSERT_EQ(copy[i], i);
  EXPECT_EQ(numbers, LargeVector<std::uint64_t>(copy.begin(), copy.begin() + 10));
}

TEST(LargeVectors, BeginWithAPageIfTheyAreLarge) {
  const LargeVector<char> large(2 * large_page);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.data()) % large_page, 0u);
}

}  // namespace
}  // namespace groundtruth::fast
