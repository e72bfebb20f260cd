#pragma once
// Doubles as text (SPEC sections 1 and 8). Reading rounds to nearest, ties to even, once; what is written
// reads back to the same bits, but for -0, which is written 0. Neither depends on the locale.

#include <string>
#include <string_view>
#include <variant>

namespace groundtruth {

struct UnreadableNumber {
  std::string problem;  // "1e400 lies outside the range of doubles"
};
using ReadNumber = std::variant<double, UnreadableNumber>;

// A JSON number. Too large, or an integer literal that no double equals: unreadable. Too small: 0.
ReadNumber read_decimal(std::string_view literal);

// "0x1.8p+0", "-0x.4P3"; the exponent may be absent. Too large: unreadable.
ReadNumber read_hex_float(std::string_view literal);

// The shortest decimal that reads back to the same bits.
std::string write_decimal(double value);

// "0x1.8p+0".
std::string write_hex_float(double value);

}  // namespace groundtruth
