#include <groundtruth/explanation/number.hpp>

#include <cmath>

#include <boost/multiprecision/cpp_dec_float.hpp>

namespace groundtruth::explanation {
namespace {

using Decimal = boost::multiprecision::cpp_dec_float_100;

Decimal decimal(const Rational& value) {
  return Decimal(numerator(value).str()) / Decimal(denominator(value).str());
}

std::string written(const Decimal& value) { return value.str(20); }

std::string digits_of(const std::string& integer) {
  constexpr std::size_t most = 40;
  return integer.size() <= most ? integer : integer.substr(0, 8) + "...";
}

}  // namespace

RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::string write_fraction(const Rational& value) {
  const std::string top = numerator(value).str();
  const std::string bottom = denominator(value).str();
  if (bottom == "1") return digits_of(top);
  std::string text = digits_of(top) + "/" + digits_of(bottom);
  if (text.find("...") != std::string::npos)
    text += " (" + std::to_string(top.size()) + " and " + std::to_string(bottom.size()) + " digits)";
  return text;
}

std::string write_approximately(const Rational& value) { return written(decimal(value)); }

std::string write_root(const Rational& value) { return written(sqrt(decimal(value))); }

double nearby(const Rational& value) { return decimal(value).convert_to<double>(); }

double nearby_root(const Rational& value) { return sqrt(decimal(value)).convert_to<double>(); }

}  // namespace groundtruth::explanation
