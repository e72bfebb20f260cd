#include <groundtruth/exact/solid/faces.hpp>

#include <gtest/gtest.h>

namespace groundtruth::exact {
namespace {

// Three planes through the origin; leaf numbers are tens of the place, so that the two cannot be mixed up.
const LocalLeaf down_x{10, {1, 0, 0}, true};
const LocalLeaf up_x{20, {-1, 0, 0}, true};
const LocalLeaf down_y{30, {0, 2, 0}, true};
const LocalLeaf left_y{30, {0, 2, 0}, false};

Expression both(Operation operation) {
  return {{operation, 3}, {Operation::leaf, 2, 0}, {Operation::leaf, 3, 1}};
}

std::vector<Leaf> admissible(const Expression& cone, const std::vector<LocalLeaf>& leaves) {
  const LocalFaces faces = faces_at(cone, leaves);
  EXPECT_FALSE(faces.interior);
  return faces.admissible;
}

TEST(Faces, ASeamIsInterior) {
  const LocalFaces faces = faces_at(both(Operation::united), {down_x, up_x});
  EXPECT_TRUE(faces.interior);
  EXPECT_TRUE(faces.admissible.empty());
}

TEST(Faces, ASheetHasTwo) {
  EXPECT_EQ(admissible(both(Operation::intersected), {down_x, up_x}), (std::vector<Leaf>{10, 20}));
}

TEST(Faces, AConvexEdgeHasBoth) {
  EXPECT_EQ(admissible(both(Operation::intersected), {down_x, down_y}), (std::vector<Leaf>{10, 30}));
}

TEST(Faces, AReentrantEdgeHasBoth) {
  EXPECT_EQ(admissible(both(Operation::united), {down_x, down_y}), (std::vector<Leaf>{10, 30}));
}

TEST(Faces, OneThatIsNotEnteredDoesNotCount) {
  EXPECT_EQ(admissible(both(Operation::intersected), {down_x, left_y}), (std::vector<Leaf>{10}));
}

TEST(Faces, NothingLeftIsInterior) { EXPECT_TRUE(faces_at({{Operation::everything, 1}}, {}).interior); }

TEST(Faces, AnEdgeWithoutFacesFallsBackOnWhatStands) {
  // x <= 0, x >= 0, y <= 0, y >= 0: the z axis.
  const Expression axis = {{Operation::intersected, 5},
                           {Operation::leaf, 2, 0},
                           {Operation::leaf, 3, 1},
                           {Operation::leaf, 4, 2},
                           {Operation::leaf, 5, 3}};
  const LocalLeaf up_y{40, {0, -1, 0}, true};
  EXPECT_EQ(admissible(axis, {down_x, up_x, left_y, up_y}), (std::vector<Leaf>{10, 20, 40}));
}

// (x <= 0 and y <= 0) or (x <= 0 and y >= 0): one half-space, whose plane is cut by a seam.
TEST(Faces, ASeamAcrossAFaceAddsNone) {
  const Expression halves = {{Operation::united, 7},  {Operation::intersected, 4}, {Operation::leaf, 3, 0},
                             {Operation::leaf, 4, 1}, {Operation::intersected, 7}, {Operation::leaf, 6, 2},
                             {Operation::leaf, 7, 3}};
  const LocalLeaf other_down_x{15, {3, 0, 0}, true};
  const LocalLeaf up_y{40, {0, -1, 0}, true};
  EXPECT_EQ(admissible(halves, {down_x, down_y, other_down_x, up_y}), (std::vector<Leaf>{10, 15}));
}

}  // namespace
}  // namespace groundtruth::exact
