// Which face counts, where normals take integers of every length and planes are few or many.

#include <groundtruth/fast/exact_stage/corner.hpp>

#include <cmath>

#include <gtest/gtest.h>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/tests/fast/shapes.hpp>
#include <groundtruth/tests/fast/with_solid.hpp>

namespace groundtruth::fast::exact_stage {
namespace {

// At the origin, through which all planes of the shape go, coming along `heading`.
std::optional<std::size_t> face_of(const Shape& shape, const Vector& heading, Arrival arrival) {
  const fast::Scene scene = compile_with_solid(groundtruth::Scene{{}, shape});
  const ExpressionView view{scene.solid().nodes, scene.solid().leaves, {}};
  LeavesNearPoint near;
  for (const HalfSpace& leaf : view.leaves) {
    const auto& n = leaf.normal;
    const bool enters = n[0] * heading[0] + n[1] * heading[1] + n[2] * heading[2] < 0;
    near.push_back(enters ? NearPoint::entered : NearPoint::not_entered);
  }
  return canonical_leaf(view, near, arrival);
}

// Between two planes that nearly coincide, the one halfway bounds nothing where they meet.
TEST(FastCorner, APlaneInsideAWedgeDoesNotBoundHoweverThinItIs) {
  for (const double slope : {0x1p-10, 0x1p-30, 0x1p-70, 0x1p-200}) {
    const Shape wedge =
        intersect({half_space({1, 0, 0}, 0), half_space({1, slope, 0}, 0), half_space({1, -slope, 0}, 0)});
    EXPECT_EQ(face_of(wedge, {-1, 0, 0}, Arrival::enters_there), 1u) << slope;
    const Shape notch =
        unite({half_space({1, 0, 0}, 0), half_space({1, slope, 0}, 0), half_space({1, -slope, 0}, 0)});
    EXPECT_EQ(face_of(notch, {-1, 0, 0}, Arrival::enters_there), 1u) << slope;
  }
}

TEST(FastCorner, TwoHalvesMakeAnInteriorHoweverTheirNormalsAreWritten) {
  for (const Vector& n : {Vector{-4, 8, 2}, Vector{0, 0x1p-30, 1}, Vector{0, 0x1p-200, 1}})
    for (const double factor : {1.0, 0x1.00001p0, 0x1.0000000001p0, 0x1.123456789abcdp300}) {
      const Shape upper = half_space({-n[0] * factor, -n[1] * factor, -n[2] * factor}, 0);
      const Shape halves = unite({half_space(n, 0), upper});
      EXPECT_EQ(face_of(halves, {0, 0, -1}, Arrival::starts_there), std::nullopt) << factor;
      const Shape sheet = intersect({upper, half_space(n, 0)});
      EXPECT_EQ(face_of(sheet, {0, 0, -1}, Arrival::enters_there), 1u) << factor;
    }
}

// The planes of a pyramid, by turns; more of them than are looked at together.
std::vector<Shape> pyramid(int count) {
  std::vector<Shape> faces;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    faces.push_back(
        half_space({std::round(5000 * std::cos(angle)), std::round(5000 * std::sin(angle)), 5000}, 0));
  }
  return faces;
}

TEST(FastCorner, EveryFaceOfAPyramidBoundsAtItsTip) {
  for (const int count : {3, 10, 33, 34, 64, 65, 150}) {
    std::vector<Shape> faces = pyramid(count);
    EXPECT_EQ(face_of(intersect(faces), {0, 0, -1}, Arrival::enters_there), 0u) << count;
    EXPECT_EQ(face_of(unite(faces), {0, 0, -1}, Arrival::enters_there), 0u) << count;
    // Seen as first leaf, a plane above the tip does not; below it, it alone does.
    faces.insert(faces.begin(), half_space({0, 0, 1}, 0));
    EXPECT_EQ(face_of(intersect(faces), {0, 0, -1}, Arrival::enters_there), 1u) << count;
    EXPECT_EQ(face_of(unite(faces), {0, 0, -1}, Arrival::enters_there), 1u) << count;
    faces.front() = half_space({0, 0, -1}, 0);
    EXPECT_EQ(face_of(unite(faces), {0, 0, -1}, Arrival::starts_there), std::nullopt) << count;
  }
}

// A sector of one line only, at the far end of the list of planes.
TEST(FastCorner, TheLastOfManyPlanesCanBeTheOneThatMakesAFaceBound) {
  std::vector<Shape> lids;
  for (int i = 1; i <= 70; ++i) lids.push_back(half_space({1.0 * i, 0, 1}, 0));
  // All of them contain the half-plane x < 0, z = 0; the last operand leaves only y < 0 of it.
  std::vector<Shape> operands{half_space({0, 0, 1}, 0)};
  operands.insert(operands.end(), lids.begin(), lids.end());
  operands.push_back(half_space({0, 1, 0}, 0));
  EXPECT_EQ(face_of(intersect(operands), {0, 0, -1}, Arrival::enters_there), 0u);
  operands.push_back(half_space({-1, 0, 0}, 0));
  EXPECT_EQ(face_of(intersect(operands), {0, 0, -1}, Arrival::enters_there), 70u);
}

}  // namespace
}  // namespace groundtruth::fast::exact_stage
