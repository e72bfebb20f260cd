// What a hierarchy of boxes guarantees, whatever the boxes.

#include <groundtruth/fast/hierarchy.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <groundtruth/fast/grid.hpp>

namespace groundtruth::fast {
namespace {

// Boxes end there: no range that is searched for in them goes so far (suit_boxes).
constexpr double greatest_float = double{std::numeric_limits<float>::max()};

struct Visited {
  std::vector<int> times;  // by part
  std::uint32_t depth = 0;
};

// Every child's box has to lie in `around`, and a part's has to hold the part.
void visit(const std::vector<Box>& boxes, const BoxHierarchy& hierarchy, std::uint32_t place,
           const Box& around, std::uint32_t depth, Visited& visited) {
  visited.depth = std::max(visited.depth, depth);
  const BoxNode& node = hierarchy.nodes[place];
  for (std::uint32_t i = 0; i < BoxNode::width && node.children[i] != BoxNode::no_child; ++i) {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = double{node.low[axis][i]};
      box.high[axis] = double{node.high[axis][i]};
      ASSERT_TRUE(around.low[axis] <= box.low[axis] && box.high[axis] <= around.high[axis]);
    }
    if (node.children[i] < BoxNode::first_part) {
      visit(boxes, hierarchy, node.children[i], box, depth + 1, visited);
      continue;
    }
    const std::uint32_t part = node.children[i] - BoxNode::first_part;
    ++visited.times[part];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_LE(box.low[axis], std::max(boxes[part].low[axis], -greatest_float));
      EXPECT_GE(box.high[axis], std::min(boxes[part].high[axis], greatest_float));
    }
  }
}

Visited visit(const std::vector<Box>& boxes) {
  std::vector<std::uint32_t> parts;
  for (std::uint32_t part = 0; part < boxes.size(); ++part) parts.push_back(part);
  const BoxHierarchy hierarchy = build_hierarchy(boxes, parts);
  Visited visited{std::vector<int>(boxes.size()), 0};
  visit(boxes, hierarchy, 0, Box{}, 1, visited);
  return visited;
}

Box cube(const Vector& low, double side) { return {low, {low[0] + side, low[1] + side, low[2] + side}}; }

TEST(BoxHierarchies, HoldEveryPartOnceInBoxesAroundIt) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-1000, 1000), side(0, 20);
  std::vector<Box> boxes;
  for (int i = 0; i < 5000; ++i)
    boxes.push_back(cube({place(random), place(random), place(random)}, side(random)));
  for (const int times : visit(boxes).times) EXPECT_EQ(times, 1);
}

TEST(GridEntries, AreReachedWhereSixPlacesOverlap) {
  std::mt19937_64 random(1);
  // Few places, so that many are the same, at both ends of what there is.
  const auto place = [&] {
    return static_cast<std::uint32_t>(random() % 4 + (random() % 2 == 0 ? 0 : Stretches::last_place - 3));
  };
  const auto some = [&] { return Stretches{place(), place(), place(), place(), place(), place()}; };
  unsigned reached = 0;
  for (int i = 0; i < 100000; ++i) {
    const Stretches part = some(), range = some();
    const bool overlap = part.first_across <= range.last_across && range.first_across <= part.last_across &&
                         part.first_along <= range.last_along && range.first_along <= part.last_along &&
                         part.first_upward <= range.last_upward && range.first_upward <= part.last_upward;
    ASSERT_EQ(Stretches::reach(range.of_range(), part.of_part()), overlap ? 1u : 0u) << i;
    reached += overlap;
  }
  EXPECT_GT(reached, 1000u);
}

TEST(BoxHierarchies, HaveFullNodes) {
  std::vector<Box> boxes;
  std::vector<std::uint32_t> parts;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    parts.push_back(i);
    boxes.push_back(cube({3.0 * (i % 64), 3.0 * (i / 64), 0}, 1));
  }
  EXPECT_LT(build_hierarchy(boxes, parts).nodes.size(), 4096u / 4);
}

TEST(BoxHierarchies, ShareOutBoxesOfOnePlace) {
  const Visited visited = visit(std::vector<Box>(1000, cube({1, 2, 3}, 1)));
  for (const int times : visited.times) EXPECT_EQ(times, 1);
  EXPECT_LE(visited.depth, 10u);
}

TEST(BoxHierarchies, HoldUnboundedParts) {
  std::vector<Box> boxes(20, cube({0, 0, 0}, 1));
  for (std::size_t i = 0; i < boxes.size(); i += 2) boxes[i].high[i % 3] = unbounded;
  const BoxHierarchy hierarchy = build_hierarchy(boxes, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  std::size_t parts = 0;
  for (const BoxNode& node : hierarchy.nodes)
    for (const std::uint32_t child : node.children)
      parts += child >= BoxNode::first_part && child != BoxNode::no_child;
  EXPECT_EQ(parts, 10u);
}

TEST(BoxHierarchies, HoldPartsAsFarOrAsCloseAsDoublesAllow) {
  for (const double size : {1e308, 3e38, 1e-42, 5e-324}) {
    std::vector<Box> boxes;
    for (int i = -50; i <= 50; ++i) boxes.push_back({{size * i / 50, 0, -size}, {size, size, size * i / 50}});
    for (const int times : visit(boxes).times) EXPECT_EQ(times, 1);
  }
}

// Each cut takes few boxes off the rest, over and over.
TEST(BoxHierarchies, AreNoDeeperThanASearchCanBear) {
  std::vector<Box> boxes;
  for (int i = -120; i <= 120; ++i)
    for (int copy = 0; copy < 20; ++copy)
      boxes.push_back(cube({std::ldexp(1.0, i), 0, 0}, std::ldexp(0.25, i)));
  const Visited visited = visit(boxes);
  EXPECT_LE(visited.depth, BoxNode::most_depth);
  for (const int times : visited.times) EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace groundtruth::fast
