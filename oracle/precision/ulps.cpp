#include <groundtruth/precision/ulps.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

namespace groundtruth::precision {
namespace {

using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

Rational power(unsigned base, long exponent) {
  const Integer whole =
      boost::multiprecision::pow(Integer(base), static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(Integer(1), whole) : Rational(whole);
}

Rational decimal(const std::string& text) {
  const auto e = text.find_first_of("eE");
  std::string digits = text.substr(0, e);
  long exponent = e == std::string::npos ? 0 : std::stol(text.substr(e + 1));
  const bool is_negative = digits.starts_with('-');
  if (is_negative || digits.starts_with('+')) digits.erase(0, 1);
  const auto point = digits.find('.');
  if (point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  // Leading zeros would make it octal.
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const Rational value = Rational(Integer(digits)) * power(10, exponent);
  return is_negative ? Rational(-value) : value;
}

Rational number(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return decimal(text);
  return Rational(Integer(text.substr(0, slash)), Integer(text.substr(slash + 1)));
}

Rational ulp_of(const Rational& value) {
  constexpr long least = -1074;
  if (value.is_zero()) return power(2, least);
  const Integer numerator = boost::multiprecision::abs(boost::multiprecision::numerator(value));
  const Integer denominator = boost::multiprecision::denominator(value);
  long binade = static_cast<long>(msb(numerator)) - static_cast<long>(msb(denominator));
  if (Rational(numerator, denominator) < power(2, binade)) --binade;
  return power(2, std::max(binade - 52, least));
}

double in_units(double got, const Rational& exact, const Rational& unit) {
  constexpr double largest = std::numeric_limits<double>::max();
  if (!std::isfinite(got)) return largest;
  const Rational error = boost::multiprecision::abs(Rational(Rational(got) - exact)) / unit;
  return error > Rational(largest) ? largest : error.convert_to<double>();
}

double error_of(const Vector& got, const Vector& exact, const std::string& name, const Evidence& evidence) {
  std::array<Rational, 3> truth{Rational(exact[0]), Rational(exact[1]), Rational(exact[2])};
  for (const Enclosure& enclosure : evidence.enclosures)
    for (std::size_t i = 0; i < 3; ++i)
      if (enclosure.quantity == name + "[" + std::to_string(i) + "]") truth[i] = number(enclosure.lower);
  Rational largest;
  for (const Rational& component : truth)
    largest = std::max(largest, Rational(boost::multiprecision::abs(component)));
  const Rational unit = ulp_of(largest);
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, in_units(got[i], truth[i], unit));
  return worst;
}

double lambda_of(const EntryAnswer& answer) {
  if (const auto* border = std::get_if<Border>(&answer)) return border->lambda;
  if (const auto* inside = std::get_if<Inside>(&answer)) return inside->lambda;
  return 0;
}

double error_of(const EntryAnswer& got, const EntryAnswer& exact, const Evidence& evidence) {
  if (std::holds_alternative<Miss>(exact)) return 0;
  return error_in_ulps(lambda_of(got), evidence.lambda_exact);
}

double error_of(const ClipAnswer& got, const ClipAnswer& exact, const Evidence& evidence) {
  const auto* clipped = std::get_if<Clipped>(&exact);
  if (clipped == nullptr) return 0;
  return error_of(std::get<Clipped>(got).force_in_wheel, clipped->force_in_wheel, "force", evidence);
}

double error_of(const StepAnswer& got, const StepAnswer& exact, const Evidence& evidence) {
  const auto* stepped = std::get_if<Stepped>(&exact);
  if (stepped == nullptr) return 0;
  const Stepped& said = std::get<Stepped>(got);
  double worst = error_of(said.force_on_frame_in_world, stepped->force_on_frame_in_world, "force", evidence);
  if (const auto* contact = std::get_if<Contact>(&stepped->state)) {
    const Contact& other = std::get<Contact>(said.state);
    worst =
        std::max({worst, error_of(other.pebble_in_world, contact->pebble_in_world, "state.pebble", evidence),
                  error_of(other.pebble_velocity_in_world, contact->pebble_velocity_in_world,
                           "state.velocity", evidence)});
  }
  return worst;
}

}  // namespace

double error_in_ulps(double got, const std::string& exact) {
  const Rational value = number(exact);
  return in_units(got, value, ulp_of(value));
}

double error_in_ulps(const Answer& got, const Answer& exact, const Evidence& evidence) {
  return std::visit(
      [&](const auto& truth) {
        return error_of(std::get<std::decay_t<decltype(truth)>>(got), truth, evidence);
      },
      exact);
}

}  // namespace groundtruth::precision
