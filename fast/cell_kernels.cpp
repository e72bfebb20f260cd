#include <groundtruth/fast/cell_kernels.hpp>

#ifdef GROUNDTRUTH_AVX2_KERNELS
#include <groundtruth/fast/cell_kernels_avx2.hpp>
#endif

namespace groundtruth::fast {

const CellKernels& best_cell_kernels() {
#ifdef GROUNDTRUTH_AVX2_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_cell_kernels;
#endif
  return portable_cell_kernels;
}

}  // namespace groundtruth::fast
