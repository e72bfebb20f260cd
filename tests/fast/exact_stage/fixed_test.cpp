#include <groundtruth/fast/exact_stage/fixed.hpp>

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

namespace groundtruth::fast::exact_stage {
namespace {

using boost::multiprecision::cpp_int;

template <std::size_t words>
cpp_int value_of(const Fixed<words>& x) {
  cpp_int value = 0;
  for (std::size_t i = words; i > 0; --i) value = (value << 64) + x.word(i - 1);
  return x.is_negative() ? value - (cpp_int(1) << (64 * words)) : value;
}

// Of any length up to `bits`, often with long runs of equal bits.
template <std::size_t words>
Fixed<words> any_fixed(std::mt19937_64& random, int bits) {
  const int length = static_cast<int>(random() % static_cast<unsigned>(bits + 1));
  Fixed<words> x(0);
  for (int i = 0; i < length; i += 31) {
    const std::uint64_t kind = random() % 4;
    const std::int64_t part = kind == 0   ? 0
                              : kind == 1 ? 0x7fffffff
                                          : static_cast<std::int64_t>(random() >> 33);
    x = x.shifted(std::min(31, length - i)) + Fixed<words>(part >> std::max(0, 31 - (length - i)));
  }
  return random() % 2 ? x : -x;
}

template <std::size_t words>
void expect_integers() {
  std::mt19937_64 random(words);
  constexpr int bits = Fixed<words>::bits;
  for (int i = 0; i < 20000; ++i) {
    const auto a = any_fixed<words>(random, bits), b = any_fixed<words>(random, bits);
    ASSERT_EQ(value_of(full_product(a, b)), value_of(a) * value_of(b));
    ASSERT_EQ(a.sign(), value_of(a).sign());
    const auto c = any_fixed<words>(random, bits - 1), d = any_fixed<words>(random, bits - 1);
    ASSERT_EQ(value_of(c + d), value_of(c) + value_of(d));
    ASSERT_EQ(value_of(c - d), value_of(c) - value_of(d));
    const auto e = any_fixed<words>(random, bits / 2), f = any_fixed<words>(random, bits / 2);
    ASSERT_EQ(value_of(e * f), value_of(e) * value_of(f));
    const int shift = static_cast<int>(random() % static_cast<unsigned>(bits / 2));
    ASSERT_EQ(value_of(e.shifted(shift)), value_of(e) * (cpp_int(1) << shift));
    const auto number = exact_double(a);
    ASSERT_EQ(number.has_value(), abs(value_of(a)) < cpp_int(1) << 53);
    ASSERT_EQ(number ? cpp_int(*number) : value_of(a), value_of(a));
  }
}

TEST(FastFixed, CountsLikeTheIntegers) {
  expect_integers<1>();
  expect_integers<2>();
  expect_integers<4>();
}

}  // namespace
}  // namespace groundtruth::fast::exact_stage
