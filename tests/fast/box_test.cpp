#include <groundtruth/fast/box.hpp>

#include <random>

#include <gtest/gtest.h>

namespace groundtruth {
namespace {

using fast::Box;
using fast::box_around;

std::vector<HalfSpace> cube(double size) {
  return {{{1, 0, 0}, size},  {{-1, 0, 0}, size}, {{0, 1, 0}, size},
          {{0, -1, 0}, size}, {{0, 0, 1}, size},  {{0, 0, -1}, size}};
}

TEST(FastBox, OfACubeIsTheCubeButForTheLastBits) {
  const Box box = box_around(cube(3));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(box.low[axis], -3);
    EXPECT_GE(box.low[axis], -3 - 1e-14);
    EXPECT_GE(box.high[axis], 3);
    EXPECT_LE(box.high[axis], 3 + 1e-14);
  }
}

TEST(FastBox, OfAHalfSpaceIsUnbounded) {
  const std::vector<HalfSpace> ground{{{0, 0, 1}, 0}};
  EXPECT_FALSE(box_around(ground).is_bounded());
  EXPECT_GE(box_around(ground).high[2], 0);
  EXPECT_LT(box_around(ground).high[2], 1e-100);
}

TEST(FastBox, OfNothingIsEmpty) {
  EXPECT_TRUE(box_around(std::vector<HalfSpace>{{{1, 0, 0}, 0}, {{-1, 0, 0}, -1}}).is_empty());
  EXPECT_FALSE(box_around(std::vector<HalfSpace>{{{1, 0, 0}, 1}, {{-1, 0, 0}, -1}}).is_empty());
}

// Cells around known points, some of them corners: no box may cut one off.
TEST(FastBox, HoldsEveryPointOfItsCellAndIsTightOnOctahedra) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vector inside{1000 * number(engine), 1000 * number(engine), number(engine)};
    std::vector<HalfSpace> faces;
    for (const double x : {-1, 1})
      for (const double y : {-1, 1})
        for (const double z : {-1, 1}) {
          const Vector n{x * (1 + 0.5 * number(engine)), y * (1 + 0.5 * number(engine)), z};
          faces.push_back({n, n[0] * inside[0] + n[1] * inside[1] + n[2] * inside[2] + 1});
        }
    const Box box = box_around(faces);
    ASSERT_TRUE(box.is_bounded());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LT(box.high[axis], inside[axis] + 10);
      ASSERT_GT(box.low[axis], inside[axis] - 10);
    }
    for (int j = 0; j < 200; ++j) {
      const Vector x{inside[0] + 3 * number(engine), inside[1] + 3 * number(engine),
                     inside[2] + 3 * number(engine)};
      bool is_member = true;
      for (const auto& [n, d] : faces) is_member &= n[0] * x[0] + n[1] * x[1] + n[2] * x[2] <= d - 1e-9;
      for (std::size_t axis = 0; is_member && axis < 3; ++axis) {
        ASSERT_LE(x[axis], box.high[axis]);
        ASSERT_GE(x[axis], box.low[axis]);
      }
    }
  }
}

TEST(FastBox, OfNearlyDependentNormalsIsNotCutShort) {
  // The roof of a house turned by an arbitrary angle: wall and roof normals are dependent but for rounding.
  const double t = 0.3219699507464362, s = 0.86409507810238084, st = 0.27821264973686149;
  const std::vector<HalfSpace> house{{{t, -1, 0}, 25.098313043241262},
                                     {{-t, 1, 0}, -16.786211342615744},
                                     {{1, t, 0}, 116.48907934901986},
                                     {{-1, -t, 0}, -107.86509429650714},
                                     {{s, st, 1.0505544484621741}, 105.36683094535672},
                                     {{-s, -st, 1.0505544484621741}, -88.496506253470045},
                                     {{0, 0, -1}, 0}};
  const Box box = box_around(house);
  ASSERT_TRUE(box.is_bounded());
  EXPECT_GT(box.high[0] - box.low[0], 8);
  EXPECT_LT(box.high[0] - box.low[0], 20);
  EXPECT_NEAR(box.high[2], (105.36683094535672 - 88.496506253470045) / 2 / 1.0505544484621741, 1e-9);
}

TEST(FastBox, TellsHowFarAHalfSpaceIs) {
  const Box box = box_around(cube(1));
  EXPECT_LT(fast::greatest_delta({{1, 1, 0}, 2.5}, box), 0);
  EXPECT_GE(fast::greatest_delta({{1, 1, 0}, 2}, box), 0);
  EXPECT_EQ(fast::greatest_delta({{1, 1, 0}, 2}, Box{}), fast::unbounded);
}

}  // namespace
}  // namespace groundtruth
