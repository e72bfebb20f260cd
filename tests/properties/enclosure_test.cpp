// Digits on request: the two decimals of an enclosure hold the exact value between them, one unit of the last
// digit apart, or are the value.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/exact/clip.hpp>
#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/tests/properties/exact_clip.hpp>

namespace groundtruth::properties {
namespace {

struct Decimal {
  Rational value;
  Rational unit;  // of its last digit
  std::size_t digits = 0;
};

Decimal decimal(const std::string& text) {
  const std::size_t e = text.find('e');
  const exact::Integer digits(text.substr(0, e));
  const int exponent = e == std::string::npos ? 0 : std::stoi(text.substr(e + 1));
  const exact::Integer power =
      boost::multiprecision::pow(exact::Integer(10), static_cast<unsigned>(std::abs(exponent)));
  const Rational unit = exponent < 0 ? Rational(exact::Integer(1), power) : Rational(power);
  return {Rational(digits) * unit, unit, text.substr(0, e).size() - (digits < 0 ? 1 : 0)};
}

void require_encloses(const Enclosure& enclosure, const exact::RootSum& value, unsigned digits) {
  const Decimal lower = decimal(enclosure.lower), upper = decimal(enclosure.upper);
  const int from_lower = sign(value - exact::RootSum(lower.value));
  const int from_upper = sign(value - exact::RootSum(upper.value));
  if (enclosure.lower == enclosure.upper) {
    RC_ASSERT(from_lower == 0);
    return;
  }
  RC_ASSERT(from_lower > 0);
  RC_ASSERT(from_upper < 0);
  RC_ASSERT(upper.value - lower.value == lower.unit);
  RC_ASSERT(std::max(lower.digits, upper.digits) >= digits);
}

RC_GTEST_PROP(Enclosures, OfAClippedForceHoldItBetweenThem, ()) {
  const ClipAsk ask = *rc::gen::oneOf(lattice_clips(), border_clips(), wild_clips());
  const auto digits = *rc::gen::inRange(1u, 80u);
  const auto finding = exact::clip(ask, exact::Digits{digits});
  if (!std::holds_alternative<Clipped>(finding.answer)) return;
  const auto force = ExactCase(ask).force_in_wheel();
  RC_ASSERT(finding.evidence.enclosures.size() == std::size_t{3});
  for (std::size_t i = 0; i < 3; ++i) require_encloses(finding.evidence.enclosures[i], force[i], digits);
}

RC_GTEST_PROP(Enclosures, OfLambdaHoldItBetweenThem, ()) {
  const EntryCase c = *rc::gen::oneOf(lattice_entries(), wild_entries());
  const auto digits = *rc::gen::inRange(1u, 80u);
  const auto finding = exact::entry_point(exact::Scene(Scene{{}, c.shape}), c.ask, exact::Digits{digits});
  if (std::holds_alternative<Miss>(finding.answer)) return;
  RC_ASSERT(finding.evidence.enclosures.size() == std::size_t{1});
  require_encloses(finding.evidence.enclosures[0], exact::RootSum(Rational(finding.evidence.lambda_exact)),
                   digits);
}

}  // namespace
}  // namespace groundtruth::properties
