#pragma once
// Several numbers abreast, in vectors of the 16 bytes that every x86-64 has. Not installed.
//
// Every lane is IEEE arithmetic, each operation rounded: the bits are the same on every machine. The kernels
// are templates over such lanes, so that no function of one set of instructions can stand in for another's.

#include <cstdint>

#ifdef __SSE4_1__
#include <immintrin.h>
#endif

namespace groundtruth::fast {

using V2d = double __attribute__((vector_size(16)));
using V2i = std::int64_t __attribute__((vector_size(16)));
using V4f = float __attribute__((vector_size(16)));
using V4i = std::int32_t __attribute__((vector_size(16)));

// Of two numbers, or four. greater and lesser: the second where one is NaN, or both are equal. store_whole:
// their whole parts, of numbers that have them in 32 bits.
struct TwoDoubles {
  using Number = double;
  using Vector = V2d;
  using Mask = V2i;
  static constexpr int width = 2;
  static Vector all(double x) { return Vector{x, x}; }
#ifdef __SSE4_1__
  static Vector greater(Vector a, Vector b) { return _mm_max_pd(a, b); }
  static Vector lesser(Vector a, Vector b) { return _mm_min_pd(a, b); }
  static Vector choose(Mask where, Vector a, Vector b) {
    return _mm_blendv_pd(b, a, reinterpret_cast<Vector>(where));
  }
  static unsigned bits(Mask mask) {
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<Vector>(mask)));
  }
#else
  static Vector choose(Mask where, Vector a, Vector b) { return where ? a : b; }
  static Vector greater(Vector a, Vector b) { return choose(a > b, a, b); }
  static Vector lesser(Vector a, Vector b) { return choose(a < b, a, b); }
  static unsigned bits(Mask mask) { return (mask[0] != 0 ? 1U : 0U) | (mask[1] != 0 ? 2U : 0U); }
#endif
  static void store_whole(Vector a, std::int32_t* to) {
    to[0] = static_cast<std::int32_t>(a[0]);
    to[1] = static_cast<std::int32_t>(a[1]);
  }
};

struct FourFloats {
  using Number = float;
  using Vector = V4f;
  using Mask = V4i;
  static constexpr int width = 4;
  static Vector all(float x) { return Vector{x, x, x, x}; }
#ifdef __SSE4_1__
  static Vector greater(Vector a, Vector b) { return _mm_max_ps(a, b); }
  static Vector lesser(Vector a, Vector b) { return _mm_min_ps(a, b); }
  static Vector choose(Mask where, Vector a, Vector b) {
    return _mm_blendv_ps(b, a, reinterpret_cast<Vector>(where));
  }
  static unsigned bits(Mask mask) {
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<Vector>(mask)));
  }
#else
  static Vector choose(Mask where, Vector a, Vector b) { return where ? a : b; }
  static Vector greater(Vector a, Vector b) { return choose(a > b, a, b); }
  static Vector lesser(Vector a, Vector b) { return choose(a < b, a, b); }
  static unsigned bits(Mask mask) {
    unsigned bits = 0;
    for (int i = 0; i < width; ++i) bits |= mask[i] != 0 ? 1U << i : 0U;
    return bits;
  }
#endif
};

// One vector.
template <class Of>
struct OneVector {
  using Number = typename Of::Number;
  static constexpr int width = Of::width;

  struct Choice {
    typename Of::Mask mask;
    friend Choice operator&(Choice a, Choice b) { return {a.mask & b.mask}; }
    friend Choice operator|(Choice a, Choice b) { return {a.mask | b.mask}; }
    unsigned bits() const { return Of::bits(mask); }  // the first lane's lowest
  };

  typename Of::Vector vector;

  // Anywhere among numbers.
  using InMemory [[gnu::aligned(alignof(Number)), gnu::may_alias]] = typename Of::Vector;

  static OneVector all(Number x) { return {Of::all(x)}; }
  static OneVector four(Number a, Number b, Number c, Number d) { return {typename Of::Vector{a, b, c, d}}; }
  static OneVector load(const Number* from) { return {*reinterpret_cast<const InMemory*>(from)}; }
  void store(Number* to) const { *reinterpret_cast<InMemory*>(to) = vector; }
  void store_whole(std::int32_t* to) const { Of::store_whole(vector, to); }
  Number operator[](int lane) const { return vector[lane]; }

  friend OneVector operator+(OneVector a, OneVector b) { return {a.vector + b.vector}; }
  friend OneVector operator-(OneVector a, OneVector b) { return {a.vector - b.vector}; }
  friend OneVector operator*(OneVector a, OneVector b) { return {a.vector * b.vector}; }
  friend OneVector operator/(OneVector a, OneVector b) { return {a.vector / b.vector}; }
  OneVector operator-() const { return {-vector}; }
  friend Choice operator<(OneVector a, OneVector b) { return {a.vector < b.vector}; }
  friend Choice operator>(OneVector a, OneVector b) { return {a.vector > b.vector}; }
  friend Choice operator<=(OneVector a, OneVector b) { return {a.vector <= b.vector}; }
  friend Choice operator>=(OneVector a, OneVector b) { return {a.vector >= b.vector}; }
  friend OneVector choose(Choice where, OneVector a, OneVector b) {
    return {Of::choose(where.mask, a.vector, b.vector)};
  }
  friend OneVector greater(OneVector a, OneVector b) { return {Of::greater(a.vector, b.vector)}; }
  friend OneVector lesser(OneVector a, OneVector b) { return {Of::lesser(a.vector, b.vector)}; }

  // Of four: the first two of each.
  friend OneVector first_halves(OneVector a, OneVector b) {
    return {__builtin_shufflevector(a.vector, b.vector, 0, 1, 4, 5)};
  }

  Number greatest() const {
    const OneVector best = greater(*this, halves_swapped());
    return best[0] > best[1] ? best[0] : best[1];
  }
  Number least() const {
    const OneVector best = lesser(*this, halves_swapped());
    return best[0] < best[1] ? best[0] : best[1];
  }

 private:
  OneVector halves_swapped() const {
    static_assert(width == 2 || width == 4);
    if constexpr (width == 2)
      return {__builtin_shufflevector(vector, vector, 1, 0)};
    else
      return {__builtin_shufflevector(vector, vector, 2, 3, 0, 1)};
  }
};

// Two vectors as one.
template <class Of>
struct TwoVectors {
  using Half = OneVector<Of>;
  using Number = typename Of::Number;
  static constexpr int width = 2 * Of::width;

  struct Choice {
    typename Half::Choice low, high;
    friend Choice operator&(Choice a, Choice b) { return {a.low & b.low, a.high & b.high}; }
    friend Choice operator|(Choice a, Choice b) { return {a.low | b.low, a.high | b.high}; }
    unsigned bits() const { return low.bits() | high.bits() << Of::width; }
  };

  Half low, high;

  static TwoVectors all(Number x) { return {Half::all(x), Half::all(x)}; }
  static TwoVectors four(Number a, Number b, Number c, Number d) {
    return {{typename Of::Vector{a, b}}, {typename Of::Vector{c, d}}};
  }
  static TwoVectors load(const Number* from) { return {Half::load(from), Half::load(from + Of::width)}; }
  void store(Number* to) const {
    low.store(to);
    high.store(to + Of::width);
  }
  void store_whole(std::int32_t* to) const {
    low.store_whole(to);
    high.store_whole(to + Of::width);
  }
  Number operator[](int lane) const { return lane < Of::width ? low[lane] : high[lane - Of::width]; }

  friend TwoVectors operator+(TwoVectors a, TwoVectors b) { return {a.low + b.low, a.high + b.high}; }
  friend TwoVectors operator-(TwoVectors a, TwoVectors b) { return {a.low - b.low, a.high - b.high}; }
  friend TwoVectors operator*(TwoVectors a, TwoVectors b) { return {a.low * b.low, a.high * b.high}; }
  friend TwoVectors operator/(TwoVectors a, TwoVectors b) { return {a.low / b.low, a.high / b.high}; }
  TwoVectors operator-() const { return {-low, -high}; }
  friend Choice operator<(TwoVectors a, TwoVectors b) { return {a.low < b.low, a.high < b.high}; }
  friend Choice operator>(TwoVectors a, TwoVectors b) { return {a.low > b.low, a.high > b.high}; }
  friend Choice operator<=(TwoVectors a, TwoVectors b) { return {a.low <= b.low, a.high <= b.high}; }
  friend Choice operator>=(TwoVectors a, TwoVectors b) { return {a.low >= b.low, a.high >= b.high}; }
  friend TwoVectors choose(Choice where, TwoVectors a, TwoVectors b) {
    return {choose(where.low, a.low, b.low), choose(where.high, a.high, b.high)};
  }
  friend TwoVectors greater(TwoVectors a, TwoVectors b) {
    return {greater(a.low, b.low), greater(a.high, b.high)};
  }
  friend TwoVectors lesser(TwoVectors a, TwoVectors b) {
    return {lesser(a.low, b.low), lesser(a.high, b.high)};
  }

  friend TwoVectors first_halves(TwoVectors a, TwoVectors b) { return {a.low, b.low}; }

  Number greatest() const { return greater(low, high).greatest(); }
  Number least() const { return lesser(low, high).least(); }
};

using Lanes = TwoVectors<TwoDoubles>;       // four
using FloatLanes = TwoVectors<FourFloats>;  // eight

}  // namespace groundtruth::fast
