#pragma once
// A hierarchy of boxes, eight abreast, over the parts of a solid.

#include <cstdint>
#include <span>
#include <vector>

#include <groundtruth/fast/box.hpp>
#include <groundtruth/fast/large_vector.hpp>

namespace groundtruth::fast {

// Boxes in floats, rounded outwards. Children from first_part on are parts, the others nodes; no_child ends
// them.
struct alignas(64) BoxNode {
  static constexpr std::uint32_t width = 8;
  static constexpr std::uint32_t first_part = 0x80000000;
  static constexpr std::uint32_t no_child = 0xffffffff;
  // From here on parts are halved, so that there are at most 32 levels below.
  static constexpr std::uint32_t most_uneven_depth = 32;
  static constexpr std::uint32_t most_depth = most_uneven_depth + 32;

  float low[3][width];
  float high[3][width];
  std::uint32_t children[width];
};

struct BoxHierarchy {
  LargeVector<BoxNode> nodes;  // the first is the root; none: no parts
};

// Over boxes[part] of the parts named, which must not be empty boxes. Cut by the surface area heuristic.
BoxHierarchy build_hierarchy(std::span<const Box> boxes, const std::vector<std::uint32_t>& parts);

float rounded_down(double x);
float rounded_up(double x);

}  // namespace groundtruth::fast
