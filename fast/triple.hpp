#pragma once
// Three numbers abreast: the components of a vector, in the lanes of one register of 32 bytes or of two
// of 16. Not installed.
//
// Every lane is IEEE arithmetic, each operation rounded: the bits are the same on every machine. A fourth
// lane is 0 at first; nothing depends on it.

#include <cmath>
#include <cstddef>
#include <cstdint>

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <groundtruth/fast/dispatch.hpp>
#include <groundtruth/fast/lanes.hpp>
#include <groundtruth/problem/vector.hpp>

namespace groundtruth::fast {

inline constexpr double least_normal = 0x1p-900, greatest_normal = 0x1.fffffffffffffp1023;

// What every x86-64 has.
struct HalfRegisters {
  struct Lanes {
    V2d first, second;
  };

  static void set(double x, double y, double z, Lanes& to) { to = {V2d{x, y}, V2d{z, z}}; }
  static void spread(double x, Lanes& to) { to = {V2d{x, x}, V2d{x, x}}; }
  static void copy(const Lanes& a, Lanes& to) { to = a; }
  static double get(const Lanes& a, std::size_t axis) { return axis < 2 ? a.first[axis] : a.second[0]; }
  static void add(const Lanes& a, const Lanes& b, Lanes& to) {
    to = {a.first + b.first, a.second + b.second};
  }
  static void subtract(const Lanes& a, const Lanes& b, Lanes& to) {
    to = {a.first - b.first, a.second - b.second};
  }
  static void multiply(const Lanes& a, const Lanes& b, Lanes& to) {
    to = {a.first * b.first, a.second * b.second};
  }
  static void negate(const Lanes& a, Lanes& to) { to = {-a.first, -a.second}; }
  static void next(const Lanes& a, Lanes& to) {
    to = {__builtin_shufflevector(a.first, a.second, 1, 2), __builtin_shufflevector(a.first, a.second, 0, 3)};
  }
  static void take_magnitude(const Lanes& a, Lanes& to) { to = {magnitude(a.first), magnitude(a.second)}; }
  // Of each axis: whether a = b, neither subnormal nor infinite. The first axis's is the lowest bit.
  static unsigned bits_where_same(const Lanes& a, const Lanes& b) {
    return TwoDoubles::bits(are_same(a.first, b.first)) |
           (TwoDoubles::bits(are_same(a.second, b.second)) & 1U) << 2;
  }

 private:
  static V2d magnitude(V2d a) { return V2d(V2i(a) & std::int64_t{0x7fffffffffffffff}); }
  static V2i are_same(V2d a, V2d b) {
    return (a == b) & (magnitude(a) >= least_normal) & (magnitude(a) <= greatest_normal);
  }
};

// What AVX2 has, and products with what they lose: within functions that may use them. Whoever calls one that
// may not be inlined hands lanes by reference, since instructions change how they are handed by value.
struct WholeRegister {
  using Lanes = double __attribute__((vector_size(32)));
  using Mask = std::int64_t __attribute__((vector_size(32)));

  GROUNDTRUTH_ABREAST static void set(double x, double y, double z, Lanes& to) { to = Lanes{x, y, z, z}; }
  GROUNDTRUTH_ABREAST static void spread(double x, Lanes& to) { to = Lanes{x, x, x, x}; }
  GROUNDTRUTH_ABREAST static void copy(const Lanes& a, Lanes& to) { to = a; }
  GROUNDTRUTH_ABREAST static double get(const Lanes& a, std::size_t axis) { return a[axis]; }
  GROUNDTRUTH_ABREAST static void add(const Lanes& a, const Lanes& b, Lanes& to) { to = a + b; }
  GROUNDTRUTH_ABREAST static void subtract(const Lanes& a, const Lanes& b, Lanes& to) { to = a - b; }
  GROUNDTRUTH_ABREAST static void multiply(const Lanes& a, const Lanes& b, Lanes& to) { to = a * b; }
  GROUNDTRUTH_ABREAST static void negate(const Lanes& a, Lanes& to) { to = -a; }
  GROUNDTRUTH_ABREAST static void next(const Lanes& a, Lanes& to) {
    to = __builtin_shufflevector(a, a, 1, 2, 0, 3);
  }
  GROUNDTRUTH_ABREAST static void take_magnitude(const Lanes& a, Lanes& to) {
    to = Lanes(Mask(a) & std::int64_t{0x7fffffffffffffff});
  }
  GROUNDTRUTH_ABREAST static unsigned bits_where_same(const Lanes& a, const Lanes& b) {
    const Lanes size = Lanes(Mask(a) & std::int64_t{0x7fffffffffffffff});
    const Mask same = (a == b) & (size >= least_normal) & (size <= greatest_normal);
#ifdef __x86_64__
    return static_cast<unsigned>(_mm256_movemask_pd(Lanes(same))) & 7U;
#else
    return (same[0] != 0 ? 1U : 0U) | (same[1] != 0 ? 2U : 0U) | (same[2] != 0 ? 4U : 0U);
#endif
  }
  // a b - c, rounded once.
  GROUNDTRUTH_ABREAST static void multiply_and_subtract(const Lanes& a, const Lanes& b, const Lanes& c,
                                                        Lanes& to) {
#ifdef __x86_64__
    to = _mm256_fmsub_pd(a, b, c);
#else
    to = Lanes{__builtin_fma(a[0], b[0], -c[0]), __builtin_fma(a[1], b[1], -c[1]),
               __builtin_fma(a[2], b[2], -c[2]), __builtin_fma(a[3], b[3], -c[3])};
#endif
  }
};

template <class Registers>
class Triple {
 public:
  Triple() : Triple(0) {}
  Triple(double x) { Registers::spread(x, lanes_); }  // implicit: nothing is lost
  Triple(double x, double y, double z) { Registers::set(x, y, z, lanes_); }
  explicit Triple(const Vector& v) : Triple(v[0], v[1], v[2]) {}
  Triple(const Triple& other) { Registers::copy(other.lanes_, lanes_); }
  Triple& operator=(const Triple& other) {
    Registers::copy(other.lanes_, lanes_);
    return *this;
  }

  double operator[](std::size_t axis) const { return Registers::get(lanes_, axis); }
  explicit operator Vector() const { return {(*this)[0], (*this)[1], (*this)[2]}; }

  friend Triple operator+(const Triple& a, const Triple& b) {
    Triple sum;
    Registers::add(a.lanes_, b.lanes_, sum.lanes_);
    return sum;
  }
  friend Triple operator-(const Triple& a, const Triple& b) {
    Triple difference;
    Registers::subtract(a.lanes_, b.lanes_, difference.lanes_);
    return difference;
  }
  friend Triple operator*(const Triple& a, const Triple& b) {
    Triple product;
    Registers::multiply(a.lanes_, b.lanes_, product.lanes_);
    return product;
  }
  Triple operator-() const {
    Triple negative;
    Registers::negate(lanes_, negative.lanes_);
    return negative;
  }
  friend Triple magnitude(const Triple& a) {
    Triple size;
    Registers::take_magnitude(a.lanes_, size.lanes_);
    return size;
  }
  friend unsigned bits_where_same(const Triple& a, const Triple& b) {
    return Registers::bits_where_same(a.lanes_, b.lanes_);
  }
  // y, z and x.
  Triple next() const {
    Triple turned;
    Registers::next(lanes_, turned.lanes_);
    return turned;
  }
  // a b - c, rounded once.
  friend Triple multiply_and_subtract(const Triple& a, const Triple& b, const Triple& c) {
    Triple result;
    Registers::multiply_and_subtract(a.lanes_, b.lanes_, c.lanes_, result.lanes_);
    return result;
  }

 private:
  typename Registers::Lanes lanes_;
};

}  // namespace groundtruth::fast
