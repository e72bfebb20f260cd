#include <groundtruth/fast/cell_kernels_avx2.hpp>
#include <groundtruth/fast/lanes_wide.hpp>
#include <groundtruth/fast/search_kernels_body.hpp>

namespace groundtruth::fast {

const CellKernels avx2_cell_kernels = kernels_of<WideLanes, WideFloatLanes, WideProducts>;

}  // namespace groundtruth::fast
