#pragma once
// A number as the unevaluated sum of two doubles: some 106 bits, the range of double.

#include <cmath>

namespace groundtruth::tiers {

// |high + low| with |low| <= half an ulp of high, unless something overflowed. Relative errors of + - * are
// at most a few 2^-104, of / and roots a few more (Joldes, Muller, Popescu 2017), while no partial product
// underflows.
class DoubleDouble {
 public:
  DoubleDouble() = default;
  DoubleDouble(double value) : high_(value) {}  // implicit: every double is one
  DoubleDouble(int value) : high_(value) {}

  double high() const { return high_; }
  double low() const { return low_; }
  // Rounded to nearest.
  explicit operator double() const { return high_; }

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high_, -a.low_}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble s = sum(a.high_, b.high_), t = sum(a.low_, b.low_);
    const DoubleDouble v = quick_sum(s.high_, s.low_ + t.high_);
    return quick_sum(v.high_, t.low_ + v.low_);
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const double product = a.high_ * b.high_;
    const double error = std::fma(a.high_, b.high_, -product);
    const double cross = std::fma(a.low_, b.high_, a.high_ * b.low_);
    return quick_sum(product, error + cross);
  }
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high_ / b.high_;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high_ / b.high_;
    const DoubleDouble rest_of_rest = rest - b * DoubleDouble(second);
    return quick_sum(first, second) + DoubleDouble(rest_of_rest.high_ / b.high_);
  }
  friend DoubleDouble sqrt(const DoubleDouble& a) {
    if (a.high_ == 0) return a;
    const double root = std::sqrt(a.high_);
    const DoubleDouble rest = a - DoubleDouble(root) * DoubleDouble(root);
    return quick_sum(root, rest.high_ / (2 * root));
  }

  friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) = default;
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
  }
  friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }

 private:
  DoubleDouble(double high, double low) : high_(high), low_(low) {}

  // Exact, barring overflow: Knuth's, and Dekker's for |a| >= |b|.
  static DoubleDouble sum(double a, double b) {
    const double s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
  }
  static DoubleDouble quick_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }

  double high_ = 0;
  double low_ = 0;
};

}  // namespace groundtruth::tiers
