#pragma once
// Which of a kernel's variants runs on this machine. Not installed.

namespace groundtruth::fast {

// With all that it calls inlined.
#define GROUNDTRUTH_FLAT __attribute__((flatten))

// The same bits; `fused` needs a processor with AVX2 and FMA.
enum class Kernels { portable, fused };

#if defined(__x86_64__) || defined(__i386__)
// Such a function may use these instructions. So may, within it, whatever it calls and is inlined; what is
// not stays portable.
#define GROUNDTRUTH_ABREAST __attribute__((target("avx2,fma")))
#define GROUNDTRUTH_FUSED __attribute__((target("avx2,fma"), flatten))
inline Kernels best_kernels() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? Kernels::fused : Kernels::portable;
}
#else
#define GROUNDTRUTH_ABREAST
#define GROUNDTRUTH_FUSED
inline Kernels best_kernels() { return Kernels::portable; }
#endif

}  // namespace groundtruth::fast
