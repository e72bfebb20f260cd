#include <groundtruth/text/number_text.hpp>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace groundtruth {
namespace {

double value_of(const ReadNumber& read) {
  const double* value = std::get_if<double>(&read);
  return value != nullptr ? *value : std::numeric_limits<double>::quiet_NaN();
}

std::string problem_of(const ReadNumber& read) {
  const auto* unreadable = std::get_if<UnreadableNumber>(&read);
  return unreadable != nullptr ? unreadable->problem : "";
}

TEST(ReadDecimal, RoundsToNearestOnce) {
  EXPECT_EQ(value_of(read_decimal("0.1")), 0x1.999999999999ap-4);
  EXPECT_EQ(value_of(read_decimal("1.00000000000000011102230246251565404236316680908203125")), 1.0);
  EXPECT_EQ(value_of(read_decimal("1.00000000000000011102230246251565404236316680908203126")),
            0x1.0000000000001p0);
  EXPECT_EQ(value_of(read_decimal("4.9406564584124654e-324")), 0x1p-1074);
  EXPECT_EQ(value_of(read_decimal("1.7976931348623157e308")), std::numeric_limits<double>::max());
}

TEST(ReadDecimal, TooSmallIsZeroTooLargeIsUnreadable) {
  EXPECT_EQ(value_of(read_decimal("1e-400")), 0.0);
  EXPECT_EQ(value_of(read_decimal("-1e-400")), 0.0);
  EXPECT_EQ(value_of(read_decimal("0.0000001e-320")), 0.0);
  EXPECT_EQ(problem_of(read_decimal("1e400")), "1e400 lies outside the range of doubles");
  EXPECT_EQ(problem_of(read_decimal("-0.001e400")), "-0.001e400 lies outside the range of doubles");
  EXPECT_EQ(problem_of(read_decimal("1e99999999999999999999")),
            "1e99999999999999999999 lies outside the range of doubles");
  EXPECT_EQ(value_of(read_decimal("1e-99999999999999999999")), 0.0);
  EXPECT_EQ(problem_of(read_decimal("1" + std::string(400, '0'))).substr(60),
            "... lies outside the range of doubles");
}

TEST(ReadDecimal, AnIntegerLiteralMustEqualADouble) {
  EXPECT_EQ(value_of(read_decimal("9007199254740992")), 0x1p53);
  EXPECT_EQ(problem_of(read_decimal("9007199254740993")),
            "9007199254740993 is an integer that no double equals");
  EXPECT_EQ(problem_of(read_decimal("-9007199254740993")),
            "-9007199254740993 is an integer that no double equals");
  EXPECT_EQ(value_of(read_decimal("10000000000000000000000")), 1e22);
  EXPECT_EQ(problem_of(read_decimal("100000000000000000000000")),
            "100000000000000000000000 is an integer that no double equals");
  EXPECT_EQ(value_of(read_decimal("1e23")), 1e23) << "not an integer literal: rounded";
  EXPECT_EQ(value_of(read_decimal("-0")), 0.0);
}

TEST(ReadHexFloat, ReadsWhatCPrints) {
  EXPECT_EQ(value_of(read_hex_float("0x1.8p+0")), 1.5);
  EXPECT_EQ(value_of(read_hex_float("-0X.4P3")), -2.0);
  EXPECT_EQ(value_of(read_hex_float("0x1p-1074")), 0x1p-1074);
  EXPECT_EQ(value_of(read_hex_float("0x10")), 16.0);
}

TEST(ReadHexFloat, RefusesWhatIsNone) {
  for (const char* text : {"", "1.5", "0x", "0x-1p3", "0x1.8p+0 ", " 0x1p0", "0x1p", "0xg", "inf", "nan",
                           "0x1p+1024", "0x1.8q0", "--0x1p0", "+0x1p0"}) {
    EXPECT_NE(problem_of(read_hex_float(text)), "") << text;
  }
}

TEST(ReadHexFloat, TooSmallIsZero) {
  EXPECT_EQ(value_of(read_hex_float("0x1p-2000")), 0.0);
  EXPECT_EQ(value_of(read_hex_float("-0x0.0001p-1080")), 0.0);
}

TEST(WriteDecimal, MinusZeroIsZero) { EXPECT_EQ(write_decimal(-0.0), "0"); }

TEST(WriteDecimal, IsTheShortest) {
  EXPECT_EQ(write_decimal(0.1), "0.1");
  EXPECT_EQ(write_decimal(1e23), "1e+23");
  EXPECT_EQ(write_decimal(0x1p-1074), "5e-324");
}

// Every finite bit pattern, not only the ones that a generator of doubles thinks of.
double finite_double_of(std::uint64_t bits) {
  const double value = std::bit_cast<double>(bits);
  return value - value == 0 ? value : std::bit_cast<double>(bits & 0x800FFFFFFFFFFFFFULL);
}

RC_GTEST_PROP(NumberText, ReadsBackToTheSameBits, (std::uint64_t bits)) {
  const double value = finite_double_of(bits);
  if (value == 0) return;
  RC_ASSERT(std::bit_cast<std::uint64_t>(value_of(read_decimal(write_decimal(value)))) ==
            std::bit_cast<std::uint64_t>(value));
  RC_ASSERT(std::bit_cast<std::uint64_t>(value_of(read_hex_float(write_hex_float(value)))) ==
            std::bit_cast<std::uint64_t>(value));
}

RC_GTEST_PROP(NumberText, AgreesWithTheCLibrary, (std::uint64_t digits, std::int16_t exponent)) {
  const std::string literal = std::to_string(digits) + ".5e" + std::to_string(exponent % 350);
  const double expected = std::strtod(literal.c_str(), nullptr);
  const ReadNumber read = read_decimal(literal);
  if (expected - expected != 0) {
    RC_ASSERT(problem_of(read) != "");
  } else {
    RC_ASSERT(value_of(read) == expected);
  }
}

}  // namespace
}  // namespace groundtruth
