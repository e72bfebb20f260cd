#pragma once
// Several numbers abreast, in vectors of the 16 bytes that every x86-64 has. Compilers split wider ones into
// single numbers where they are compared or chosen from. Not installed.
//
// Every lane is IEEE arithmetic, each operation rounded: the bits are the same on every machine.

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace groundtruth::fast {

// Two vectors as one. Vector: of 16 bytes; Mask: what comparing two of them gives.
template <class Number, class Vector, class Mask>
struct LanesOf {
  static constexpr int width = 2 * static_cast<int>(sizeof(Vector) / sizeof(Number));

  struct Choice {
    Mask low;
    Mask high;
    friend Choice operator&(const Choice& a, const Choice& b) { return {a.low & b.low, a.high & b.high}; }
    friend Choice operator|(const Choice& a, const Choice& b) { return {a.low | b.low, a.high | b.high}; }
    Choice operator~() const { return {~low, ~high}; }
    bool any() const {
      const Mask either = low | high;
      using Halves = std::int64_t __attribute__((vector_size(16)));
      const auto halves = reinterpret_cast<Halves>(either);
      return (halves[0] | halves[1]) != 0;
    }
    bool operator[](int lane) const {
      return lane < width / 2 ? low[lane] != 0 : high[lane - width / 2] != 0;
    }
  };

  Vector low;
  Vector high;

  static LanesOf all(Number x) { return {Vector{} + x, Vector{} + x}; }
  static LanesOf load(const Number* from) {
    LanesOf lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }
  void store(Number* to) const { std::memcpy(to, this, sizeof *this); }
  Number operator[](int lane) const { return lane < width / 2 ? low[lane] : high[lane - width / 2]; }

  friend LanesOf operator+(const LanesOf& a, const LanesOf& b) { return {a.low + b.low, a.high + b.high}; }
  friend LanesOf operator-(const LanesOf& a, const LanesOf& b) { return {a.low - b.low, a.high - b.high}; }
  friend LanesOf operator*(const LanesOf& a, const LanesOf& b) { return {a.low * b.low, a.high * b.high}; }
  friend LanesOf operator/(const LanesOf& a, const LanesOf& b) { return {a.low / b.low, a.high / b.high}; }
  LanesOf operator-() const { return {-low, -high}; }
  friend Choice operator<(const LanesOf& a, const LanesOf& b) { return {a.low < b.low, a.high < b.high}; }
  friend Choice operator>(const LanesOf& a, const LanesOf& b) { return {a.low > b.low, a.high > b.high}; }
  friend Choice operator<=(const LanesOf& a, const LanesOf& b) { return {a.low <= b.low, a.high <= b.high}; }
  friend Choice operator>=(const LanesOf& a, const LanesOf& b) { return {a.low >= b.low, a.high >= b.high}; }

  friend LanesOf choose(const Choice& where, const LanesOf& a, const LanesOf& b) {
    return {where.low ? a.low : b.low, where.high ? a.high : b.high};
  }
  // The second where one is NaN.
  friend LanesOf greater(const LanesOf& a, const LanesOf& b) { return choose(a > b, a, b); }
  friend LanesOf lesser(const LanesOf& a, const LanesOf& b) { return choose(a < b, a, b); }
};

using Lanes =
    LanesOf<double, double __attribute__((vector_size(16))), std::int64_t __attribute__((vector_size(16)))>;
using FloatLanes =
    LanesOf<float, float __attribute__((vector_size(16))), std::int32_t __attribute__((vector_size(16)))>;

}  // namespace groundtruth::fast
