#pragma once
// The order of parts in memory, and the index that finds them. Not installed.

#include <cstdint>
#include <span>
#include <vector>

#include <groundtruth/fast/box.hpp>
#include <groundtruth/fast/compile_options.hpp>
#include <groundtruth/fast/parts.hpp>

namespace groundtruth::fast {

// Parts by their new numbers, as in Parts.
struct PartIndex {
  std::vector<std::uint32_t> cells;  // the old number of each, by the new one
  std::vector<Part> apart;
  BoxHierarchy hierarchy;
  Grid grid;
};

// Over parts with these boxes, of which the first `cell_count` are cells: these get the order in which the
// hierarchy comes to them, so that neighbours in space are neighbours in memory. The others keep their
// numbers.
PartIndex index_parts(std::span<const Box> boxes, std::size_t cell_count, const CompileOptions& options);

}  // namespace groundtruth::fast
