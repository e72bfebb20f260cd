#pragma once
// The only file of fast that is compiled for processors with AVX2 and FMA. Not installed.

#include <groundtruth/fast/cell_kernels.hpp>

namespace groundtruth::fast {

extern const CellKernels avx2_cell_kernels;

}  // namespace groundtruth::fast
