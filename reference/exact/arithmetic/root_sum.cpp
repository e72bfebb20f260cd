#include <groundtruth/exact/arithmetic/root_sum.hpp>

namespace groundtruth::exact {
namespace {

// The sign of p + q sqrt(r), r >= 0.
int sign_with_root(const Rational& p, const Rational& q, const Rational& r) {
  const int sign_p = sign(p);
  const int sign_q = r.is_zero() ? 0 : sign(q);
  if (sign_q == 0 || sign_p == sign_q) return sign_p;
  if (sign_p == 0) return sign_q;
  const Rational difference = p * p - q * q * r;
  return sign_p * sign(difference);
}

// Rationals lower <= sqrt(value) <= upper, 2^-bits apart at the most.
std::array<Rational, 2> root_enclosure(const Rational& value, unsigned bits) {
  const Integer denominator = boost::multiprecision::denominator(value);
  // sqrt(n/d) = sqrt(n d 4^bits) / (d 2^bits).
  const Integer radicand = (boost::multiprecision::numerator(value) * denominator) << (2 * bits);
  Integer remainder;
  const Integer root = boost::multiprecision::sqrt(radicand, remainder);
  const Integer scale = denominator << bits;
  const Integer above = remainder.is_zero() ? root : Integer(root + 1);
  return {Rational(root, scale), Rational(above, scale)};
}

void add_multiple(std::array<Rational, 2>& sum, const Rational& factor,
                  const std::array<Rational, 2>& enclosure) {
  const bool flips = factor < 0;
  sum[0] += factor * enclosure[flips ? 1 : 0];
  sum[1] += factor * enclosure[flips ? 0 : 1];
}

}  // namespace

RootSum operator+(const RootSum& left, const RootSum& right) {
  return {left.rational_ + right.rational_, left.times_root_a_ + right.times_root_a_,
          left.times_root_d_ + right.times_root_d_, left.radicands_ ? left.radicands_ : right.radicands_};
}

RootSum operator-(const RootSum& left, const RootSum& right) { return left + right * Rational(-1); }

RootSum operator*(const RootSum& left, const Rational& right) {
  return {left.rational_ * right, left.times_root_a_ * right, left.times_root_d_ * right, left.radicands_};
}

RootSum operator/(const RootSum& left, const Rational& right) {
  return {left.rational_ / right, left.times_root_a_ / right, left.times_root_d_ / right, left.radicands_};
}

int sign(const RootSum& value) {
  if (value.is_rational()) return sign(value.rational_);
  const Rational& a = value.rational_;
  const Rational& b = value.times_root_a_;
  const Rational& c = value.times_root_d_;
  const auto& [radicand_a, radicand_d] = *value.radicands_;
  const int sign_before = sign_with_root(a, b, radicand_a);
  const int sign_last = radicand_d.is_zero() ? 0 : sign(c);
  if (sign_last == 0 || sign_before == sign_last) return sign_before;
  if (sign_before == 0) return sign_last;
  // |a + b sqrt(A)| against |c| sqrt(D), squared.
  const Rational rational = a * a + b * b * radicand_a - c * c * radicand_d;
  const Rational times_root_a = 2 * a * b;
  return sign_before * sign_with_root(rational, times_root_a, radicand_a);
}

std::array<Rational, 2> RootSum::enclosure(unsigned bits) const {
  std::array<Rational, 2> sum = {rational_, rational_};
  if (!times_root_a_.is_zero()) add_multiple(sum, times_root_a_, root_enclosure(radicands_->a, bits));
  if (!times_root_d_.is_zero()) add_multiple(sum, times_root_d_, root_enclosure(radicands_->d, bits));
  return sum;
}

std::array<RootSum, 3> RootVector::components() const {
  return {RootSum(u.x(), v.x(), w.x(), radicands), RootSum(u.y(), v.y(), w.y(), radicands),
          RootSum(u.z(), v.z(), w.z(), radicands)};
}

}  // namespace groundtruth::exact
