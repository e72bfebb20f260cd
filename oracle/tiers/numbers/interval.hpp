#pragma once
// Bounds of a number, in doubles. They are rounded outwards only where a result was not exact: no rounding
// mode is switched, and zeros that are exact stay zeros.

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundtruth::tiers {

// Thrown by a comparison that the bounds leave open.
struct BoundsOverlap {};

class Interval {
 public:
  Interval() = default;
  Interval(double value) : lower_(value), upper_(value) {}  // implicit: every double is one
  Interval(int value) : Interval(static_cast<double>(value)) {}
  Interval(double lower, double upper) : lower_(lower), upper_(upper) {}

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  // The middle, or what is nearest to it.
  explicit operator double() const {
    return lower_ == upper_ ? lower_ : std::clamp(lower_ / 2 + upper_ / 2, lower_, upper_);
  }

  friend Interval operator-(const Interval& a) { return {-a.upper_, -a.lower_}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return bounds(down_sum(a.lower_, b.lower_), up_sum(a.upper_, b.upper_));
  }
  friend Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    const double pairs[4][2] = {
        {a.lower_, b.lower_}, {a.lower_, b.upper_}, {a.upper_, b.lower_}, {a.upper_, b.upper_}};
    return hull(pairs, [](double x, double y) { return x == 0 || y == 0 ? Rounded{0, 0} : product(x, y); });
  }
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (b.lower_ <= 0 && b.upper_ >= 0) return {-infinity, infinity};
    const double pairs[4][2] = {
        {a.lower_, b.lower_}, {a.lower_, b.upper_}, {a.upper_, b.lower_}, {a.upper_, b.upper_}};
    return hull(pairs, [](double x, double y) { return x == 0 ? Rounded{0, 0} : quotient(x, y); });
  }
  friend Interval sqrt(const Interval& a) {
    const double low = std::sqrt(std::max(a.lower_, 0.0)), high = std::sqrt(std::max(a.upper_, 0.0));
    const bool low_is_exact = is_trusted(low * low) && std::fma(low, low, -a.lower_) == 0;
    const bool high_is_exact = is_trusted(high * high) && std::fma(high, high, -a.upper_) == 0;
    return bounds(low_is_exact || low == 0 ? low : before(low), high_is_exact ? high : after(high));
  }

  // Each throws BoundsOverlap unless it holds for all values, or for none.
  friend bool operator<(const Interval& a, const Interval& b) {
    if (a.upper_ < b.lower_) return true;
    if (a.lower_ >= b.upper_) return false;
    throw BoundsOverlap{};
  }
  friend bool operator>(const Interval& a, const Interval& b) { return b < a; }
  friend bool operator==(const Interval& a, const Interval& b) {
    if (a.upper_ < b.lower_ || b.upper_ < a.lower_) return false;
    if (a.lower_ == a.upper_ && b.lower_ == b.upper_ && a.lower_ == b.lower_) return true;
    throw BoundsOverlap{};
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Rounded {
    double down, up;
  };

  static double before(double value) { return std::nextafter(value, -infinity); }
  static double after(double value) { return std::nextafter(value, infinity); }

  // Overflow of a bound, or its NaN, widens to all numbers.
  static Interval bounds(double lower, double upper) {
    return {std::isnan(lower) || lower == infinity ? -infinity : lower,
            std::isnan(upper) || upper == -infinity ? infinity : upper};
  }

  // What is wrong with a rounded sum: exact unless it overflows (Knuth).
  static double error_of_sum(double a, double b, double s) {
    const double part = s - a;
    return (a - (s - part)) + (b - part);
  }
  static double down_sum(double a, double b) {
    const double s = a + b, error = error_of_sum(a, b, s);
    return error >= 0 ? s : before(s);
  }
  static double up_sum(double a, double b) {
    const double s = a + b, error = error_of_sum(a, b, s);
    return error <= 0 ? s : after(s);
  }

  // Far enough from underflow for the error of a product to be a double itself.
  static bool is_trusted(double value) { return std::fabs(value) > 0x1p-960 && std::fabs(value) < infinity; }

  static Rounded around(double value, bool is_trusted_here, double error) {
    if (!is_trusted_here) return {before(value), after(value)};
    return {error < 0 ? before(value) : value, error > 0 ? after(value) : value};
  }
  static Rounded product(double a, double b) {
    const double p = a * b;
    return around(p, is_trusted(p), std::fma(a, b, -p));
  }
  static Rounded quotient(double a, double b) {
    const double q = a / b;
    const double error = std::fma(-q, b, a);  // of q b
    return around(q, is_trusted(q) && is_trusted(a), b > 0 ? error : -error);
  }

  template <class Operation>
  static Interval hull(const double (&pairs)[4][2], const Operation& operation) {
    double lower = infinity, upper = -infinity;
    for (const auto& [a, b] : pairs) {
      const Rounded result = operation(a, b);
      if (std::isnan(result.down) || std::isnan(result.up)) return {-infinity, infinity};
      lower = std::min(lower, result.down);
      upper = std::max(upper, result.up);
    }
    return {lower, upper};
  }

  double lower_ = 0;
  double upper_ = 0;
};

}  // namespace groundtruth::tiers
