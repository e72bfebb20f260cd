#include <groundtruth/fast/lanes.hpp>
#include <groundtruth/fast/search_kernels_body.hpp>

namespace groundtruth::fast {

const CellKernels portable_cell_kernels = kernels_of<Lanes, FloatLanes, DekkerProducts<TwoDoubles>>;

}  // namespace groundtruth::fast
