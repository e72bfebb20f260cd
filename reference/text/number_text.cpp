#include <groundtruth/text/number_text.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

namespace groundtruth {
namespace {

enum class Base { ten, sixteen };

UnreadableNumber unreadable(std::string_view literal, const char* problem) {
  constexpr std::size_t enough = 60;
  std::string shown(literal.substr(0, enough));
  if (literal.size() > enough) shown += "...";
  return {shown + " " + problem};
}

// Whether a literal whose value no double holds is too large, rather than too small. from_chars says only
// that it is one of the two. Requires a digit other than 0.
bool is_large(std::string_view literal, Base base) {
  const auto exponent_at = literal.find_first_of(base == Base::ten ? "eE" : "pP");
  const std::string_view digits = literal.substr(0, exponent_at);
  const auto point = std::min(digits.find('.'), digits.size());
  const auto leading = digits.find_first_not_of("0.-");
  const std::int64_t digits_before_point =
      static_cast<std::int64_t>(point) - static_cast<std::int64_t>(leading);  // of the leading digit on
  if (exponent_at == std::string_view::npos) return digits_before_point > 0;

  std::string_view exponent_text = literal.substr(exponent_at + 1);
  const bool negative = exponent_text.front() == '-';
  if (negative || exponent_text.front() == '+') exponent_text.remove_prefix(1);
  std::int64_t exponent = 0;
  const auto end = exponent_text.data() + exponent_text.size();
  if (std::from_chars(exponent_text.data(), end, exponent).ec != std::errc{}) return !negative;
  const std::int64_t shift = base == Base::ten ? digits_before_point : 4 * digits_before_point;
  return (negative ? -exponent : exponent) + shift > 0;
}

ReadNumber convert(std::string_view literal, std::string_view digits, Base base) {
  double value = 0;
  const auto format = base == Base::ten ? std::chars_format::general : std::chars_format::hex;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, format);
  if (error == std::errc::result_out_of_range) {
    if (is_large(digits, base)) return unreadable(literal, "lies outside the range of doubles");
    return 0.0;
  }
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    return unreadable(literal, base == Base::ten ? "is not a number" : "is not a hex float (\"0x1.8p+0\")");
  }
  if (!std::isfinite(value)) return unreadable(literal, "lies outside the range of doubles");
  return value;
}

bool equals_integer_literal(double value, std::string_view literal) {
  std::array<char, 330> text;  // the largest double has 309 digits
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 0).ptr;
  return std::string_view(text.data(), static_cast<std::size_t>(end - text.data())) == literal;
}

}  // namespace

ReadNumber read_decimal(std::string_view literal) {
  const ReadNumber read = convert(literal, literal, Base::ten);
  const double* value = std::get_if<double>(&read);
  if (value == nullptr) return read;
  const bool is_integer_literal = literal.find_first_of(".eE") == std::string_view::npos;
  if (is_integer_literal && *value != 0 && !equals_integer_literal(*value, literal)) {
    return unreadable(literal, "is an integer that no double equals");
  }
  return read;
}

ReadNumber read_hex_float(std::string_view literal) {
  const bool negative = literal.starts_with('-');
  std::string_view digits = negative ? literal.substr(1) : literal;
  if (!digits.starts_with("0x") && !digits.starts_with("0X")) {
    return unreadable(literal, "is not a hex float (\"0x1.8p+0\")");
  }
  digits.remove_prefix(2);
  if (digits.empty() || digits.find_first_not_of("0123456789abcdefABCDEF.pP+-") != std::string_view::npos ||
      digits.front() == '-') {
    return unreadable(literal, "is not a hex float (\"0x1.8p+0\")");
  }
  const ReadNumber read = convert(literal, digits, Base::sixteen);
  const double* value = std::get_if<double>(&read);
  if (value == nullptr) return read;
  return negative ? -*value : *value;
}

std::string write_decimal(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0.0 : value).ptr;
  return {text.data(), end};
}

std::string write_hex_float(double value) {
  std::array<char, 32> text;
  const double magnitude = std::fabs(value);
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), magnitude, std::chars_format::hex).ptr;
  std::string written = value < 0 ? "-0x" : "0x";
  return written.append(text.data(), end);
}

}  // namespace groundtruth
