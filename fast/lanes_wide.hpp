#pragma once
// The same lanes (lanes.hpp) in vectors of the 32 bytes that AVX2 has: for files compiled for it. Not
// installed.

#include <immintrin.h>

#include <groundtruth/fast/lanes.hpp>

namespace groundtruth::fast {

using V4d = double __attribute__((vector_size(32)));
using V4l = std::int64_t __attribute__((vector_size(32)));
using V8f = float __attribute__((vector_size(32)));
using V8i = std::int32_t __attribute__((vector_size(32)));

struct FourDoubles {
  using Number = double;
  using Vector = V4d;
  using Mask = V4l;
  static constexpr int width = 4;
  static Vector all(double x) { return Vector{x, x, x, x}; }
  static Vector greater(Vector a, Vector b) { return _mm256_max_pd(a, b); }
  static Vector lesser(Vector a, Vector b) { return _mm256_min_pd(a, b); }
  static Vector choose(Mask where, Vector a, Vector b) {
    return _mm256_blendv_pd(b, a, reinterpret_cast<Vector>(where));
  }
  static unsigned bits(Mask mask) {
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<Vector>(mask)));
  }
  static void store_whole(Vector a, std::int32_t* to) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm256_cvttpd_epi32(a));
  }
};

struct EightFloats {
  using Number = float;
  using Vector = V8f;
  using Mask = V8i;
  static constexpr int width = 8;
  static Vector all(float x) { return Vector{x, x, x, x, x, x, x, x}; }
  static Vector greater(Vector a, Vector b) { return _mm256_max_ps(a, b); }
  static Vector lesser(Vector a, Vector b) { return _mm256_min_ps(a, b); }
  static Vector choose(Mask where, Vector a, Vector b) {
    return _mm256_blendv_ps(b, a, reinterpret_cast<Vector>(where));
  }
  static unsigned bits(Mask mask) {
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<Vector>(mask)));
  }
};

// Two abreast, and what their products lose. A type of its own: its instructions are those of this file.
struct TwoFusedDoubles {
  using Number = double;
  using Vector = V2d;
  using Mask = V2i;
  static constexpr int width = 2;
  static Vector all(double x) { return Vector{x, x}; }
  static Vector greater(Vector a, Vector b) { return _mm_max_pd(a, b); }
  static Vector lesser(Vector a, Vector b) { return _mm_min_pd(a, b); }
};

// Exact unless the error underflows or the product overflows: as good as Dekker's at least.
struct WideProducts {
  using Ends = OneVector<TwoFusedDoubles>;
  static Ends lost(Ends a, Ends b, Ends product) {
    return {_mm_fmsub_pd(a.vector, b.vector, product.vector)};
  }
  // a - quotient * b, of a quotient that is rounded to nearest.
  static double remainder(double a, double quotient, double b) { return __builtin_fma(-quotient, b, a); }
};

using WideLanes = OneVector<FourDoubles>;
using WideFloatLanes = OneVector<EightFloats>;

}  // namespace groundtruth::fast
