#include <groundtruth/fast/cell_kernels_body.hpp>
#include <groundtruth/fast/lanes.hpp>

namespace groundtruth::fast {

const CellKernels portable_cell_kernels = kernels_of<Lanes, FloatLanes, DekkerProducts<TwoDoubles>>;

}  // namespace groundtruth::fast
