#include <groundtruth/fast/cell_kernels_avx2.hpp>
#include <groundtruth/fast/cell_kernels_body.hpp>
#include <groundtruth/fast/lanes_wide.hpp>

namespace groundtruth::fast {

const CellKernels avx2_cell_kernels = kernels_of<WideLanes, WideFloatLanes, FusedProducts>;

}  // namespace groundtruth::fast
