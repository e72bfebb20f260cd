#pragma once
// Integers times powers of two: what sums and products of doubles are, without rounding. Not installed.

#include <bit>
#include <cstdint>

#include <boost/multiprecision/cpp_int.hpp>

namespace groundtruth::fast::exact_stage {

// Holds 1,024 bits without allocation, and as many as need be with.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;

// A finite double as mantissa * 2^exponent with an odd mantissa; zero is 0 * 2^0.
struct SplitDouble {
  std::int64_t mantissa;
  int exponent;
};

// Without branches: which of a leaf's numbers are zero is not to be guessed.
inline SplitDouble split(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t magnitude = (bits & 0xfffffffffffff) | std::uint64_t{biased != 0} << 52;
  const int zeros = std::countr_zero(magnitude | std::uint64_t{1} << 63);
  const auto mantissa = static_cast<std::int64_t>(magnitude >> zeros);
  const std::int64_t sign = -static_cast<std::int64_t>(bits >> 63);
  const int exponent = biased + (biased == 0) - 1075 + zeros;
  return {(mantissa ^ sign) - sign, magnitude == 0 ? 0 : exponent};
}

class Dyadic {
 public:
  Dyadic() = default;
  Dyadic(double x) : Dyadic(split(x)) {}  // implicit: nothing is lost
  Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  const Integer& mantissa() const { return mantissa_; }
  int exponent() const { return exponent_; }
  int sign() const { return mantissa_.sign(); }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    if (a.exponent_ == b.exponent_) return {a.mantissa_ + b.mantissa_, a.exponent_};
    return a.exponent_ > b.exponent_ ? sum_with_lower(a, b) : sum_with_lower(b, a);
  }
  friend Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }

  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == 0; }

  // Times 2^shift.
  Dyadic scaled(int shift) const { return {mantissa_, exponent_ + shift}; }

 private:
  explicit Dyadic(SplitDouble x) : mantissa_(x.mantissa), exponent_(x.exponent) {}

  static Dyadic sum_with_lower(const Dyadic& a, const Dyadic& lower) {
    return {(a.mantissa_ << (a.exponent_ - lower.exponent_)) + lower.mantissa_, lower.exponent_};
  }

  Integer mantissa_;
  int exponent_ = 0;
};

inline int sign(const Dyadic& x) { return x.sign(); }
inline Dyadic square(const Dyadic& x) { return x * x; }
inline Dyadic magnitude(const Dyadic& x) { return x.sign() < 0 ? -x : x; }

}  // namespace groundtruth::fast::exact_stage
