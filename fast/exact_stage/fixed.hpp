#pragma once
// Integers of a fixed number of 64-bit words: short enough that nothing is allocated. Not installed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace groundtruth::fast::exact_stage {

__extension__ using TwoWords = unsigned __int128;

// Two's complement. Whoever adds, subtracts, multiplies or shifts owes that the result fits, except for
// full_product, which always does.
template <std::size_t count>
class Fixed {
 public:
  static constexpr int bits = 64 * static_cast<int>(count) - 1;  // without the sign

  Fixed() = default;
  Fixed(std::int64_t x) {  // implicit: nothing is lost
    words_.fill(x < 0 ? ~std::uint64_t{0} : 0);
    words_[0] = static_cast<std::uint64_t>(x);
  }

  std::uint64_t word(std::size_t i) const { return words_[i]; }
  bool is_negative() const { return words_[count - 1] >> 63 != 0; }
  int sign() const {
    std::uint64_t any = 0;
    for (const std::uint64_t word : words_) any |= word;
    return is_negative() ? -1 : any != 0;
  }

  friend bool operator==(const Fixed&, const Fixed&) = default;
  friend Fixed operator+(const Fixed& a, const Fixed& b) { return sum(a, b, 0, 0); }
  friend Fixed operator-(const Fixed& a, const Fixed& b) { return sum(a, b, ~std::uint64_t{0}, 1); }
  friend Fixed operator-(const Fixed& a) { return Fixed{} - a; }

  friend Fixed operator*(const Fixed& a, const Fixed& b) {
    Fixed product;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; i + j < count; ++j) {
        const TwoWords sum = TwoWords{a.words_[i]} * b.words_[j] + product.words_[i + j] + carry;
        product.words_[i + j] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
      }
    }
    return product;
  }

  Fixed shifted(int left) const {
    if constexpr (count == 1) return Fixed(static_cast<std::int64_t>(words_[0] << left));
    const auto words = static_cast<std::size_t>(left / 64);
    const int rest = left % 64;
    Fixed result;
    for (std::size_t i = words; i < count; ++i) {
      result.words_[i] = words_[i - words] << rest;
      if (rest != 0 && i > words) result.words_[i] |= words_[i - words - 1] >> (64 - rest);
    }
    return result;
  }

 private:
  // a + (b xor flip) + carry.
  static Fixed sum(const Fixed& a, const Fixed& b, std::uint64_t flip, std::uint64_t carry) {
    Fixed result;
    for (std::size_t i = 0; i < count; ++i) {
      const TwoWords sum = TwoWords{a.words_[i]} + (b.words_[i] ^ flip) + carry;
      result.words_[i] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64);
    }
    return result;
  }

  template <std::size_t n>
  friend Fixed<2 * n> full_product(const Fixed<n>& a, const Fixed<n>& b);

  std::array<std::uint64_t, count> words_{};
};

template <std::size_t count>
int sign(const Fixed<count>& x) {
  return x.sign();
}

// Nothing: more than a double's bits.
template <std::size_t count>
std::optional<double> exact_double(const Fixed<count>& x) {
  const Fixed<count> magnitude = x.is_negative() ? -x : x;
  std::uint64_t above = magnitude.word(0) >> 53;
  for (std::size_t i = 1; i < count; ++i) above |= magnitude.word(i);
  if (above != 0) return std::nullopt;
  const auto value = static_cast<double>(magnitude.word(0));
  return x.is_negative() ? -value : value;
}

// The unsigned product is too large by 2^(64 n) times the other factor for each negative one.
template <std::size_t n>
Fixed<2 * n> full_product(const Fixed<n>& a, const Fixed<n>& b) {
  Fixed<2 * n> product, excess;
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const TwoWords sum = TwoWords{a.words_[i]} * b.words_[j] + product.words_[i + j] + carry;
      product.words_[i + j] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64);
    }
    product.words_[i + n] = carry;
  }
  for (std::size_t i = 0; i < n; ++i) excess.words_[i + n] = a.is_negative() ? b.words_[i] : 0;
  product = product - excess;
  for (std::size_t i = 0; i < n; ++i) excess.words_[i + n] = b.is_negative() ? a.words_[i] : 0;
  return product - excess;
}

}  // namespace groundtruth::fast::exact_stage
