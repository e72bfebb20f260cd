// Clips whose exact result is known beforehand, as whole numbers: H is a point on the edge of the border and
// the force is H plus a vector that points straight out of the border there. Surfaces, discs and corners are
// built from right triangles with whole sides, so no root is left.

#include <gtest/gtest.h>

#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

struct Plane {
  double x, y;
};

// A surface with whole r and ||n||.
struct Surface {
  Vector normal;
  double r, length;

  // Exact if x, y and z are multiples of r ||n||.
  Vector in_wheel(const Plane& tangent, double z) const {
    const double x = tangent.x / r, y = tangent.y / (r * length);
    const auto& [nx, ny, nz] = normal;
    return {-nz * x - nx * ny * y - nx * z / length, r * r * y - ny * z / length,
            nx * x - ny * nz * y - nz * z / length};
  }
};

const Surface surfaces[] = {{{0, 0, -1}, 1, 1},    {{3, 0, -4}, 5, 5},    {{-4, 0, -3}, 5, 5},
                            {{0, 3, -4}, 4, 5},    {{0, -4, -3}, 3, 5},   {{3, 12, -4}, 5, 13},
                            {{-4, 12, -3}, 5, 13}, {{3, -12, -4}, 5, 13}, {{-8, 0, -6}, 10, 10}};

// Whole points (x, y) of the circle of radius 65, by their first quadrant.
const Plane circle[] = {{65, 0},  {63, 16}, {60, 25}, {56, 33}, {52, 39},
                        {39, 52}, {33, 56}, {25, 60}, {16, 63}, {0, 65}};
constexpr double radius = 65;
constexpr double friction = 0.5;

class ClipConstructed : public ::testing::Test {
 protected:
  // Of H and outward vectors in the first quadrant, all four images; F'_z of both signs.
  void require(const Plane& h, const Plane& outward, double brake) {
    for (const Surface& surface : surfaces) {
      for (int signs = 0; signs < 8; ++signs) {
        const double sx = signs & 1 ? -1 : 1, sy = signs & 2 ? -1 : 1, sz = signs & 4 ? -1 : 1;
        const double unit = surface.r * surface.length;
        const double normal = sz * radius / friction * unit;
        const Plane clipped{sx * h.x * unit, sy * h.y * unit};
        const Plane whole{clipped.x + sx * outward.x * unit, clipped.y + sy * outward.y * unit};
        const ClipAsk ask{surface.in_wheel(whole, normal), surface.normal, friction, brake * unit};
        const bool moves = outward.x != 0 || outward.y != 0;
        const Clipped expected{moves ? Grip::slip : Grip::stick, surface.in_wheel(clipped, normal)};
        ASSERT_EQ(clip(ask), ClipAnswer(expected)) << replay({{}, {Nothing{}}}, ask);
        ++cases_;
      }
    }
  }

  int cases_ = 0;
};

TEST_F(ClipConstructed, OnTheDiscTheNormalConeIsTheRay) {
  for (const Plane& h : circle)
    for (const double t : {0.0, 0.5, 1.0, 7.0})
      for (const double brake : {h.x + 1, h.x + 0.125, radius, 1000.0}) require(h, {t * h.x, t * h.y}, brake);
  EXPECT_GE(cases_, 10'000);
}

TEST_F(ClipConstructed, OnTheBandTheNormalConeIsItsDirection) {
  for (const Plane& corner : circle) {
    if (corner.x == radius) continue;
    for (const double part : {0.0, 0.25, 0.5, 1.0})
      for (const double t : {0.0, 1.0, 1000.0}) require({corner.x, part * corner.y}, {t, 0}, corner.x);
  }
}

// Its two edges, the direction of the band and the ray, belong to the corner's cone.
TEST_F(ClipConstructed, AtTheCornerTheNormalConeIsSpannedByBoth) {
  for (const Plane& corner : circle) {
    if (corner.x == radius) continue;
    for (const double along_band : {0.0, 1.0, 3.0, 500.0})
      for (const double along_ray : {0.0, 0.5, 1.0, 4.0})
        require(corner, {along_band + along_ray * corner.x, along_ray * corner.y}, corner.x);
  }
}

TEST_F(ClipConstructed, WithoutBrakeOnlySidewaysForceIsLeft) {
  for (const double y : {0.0, 16.0, 64.0, 65.0}) require({0, y}, {33, 0}, 0);
  require({0, 65}, {5, 10}, 0);
}

TEST_F(ClipConstructed, InsideTheBorderForcesStay) {
  for (const Plane& h : circle) require({h.x * 0.5, h.y * 0.5}, {0, 0}, h.x);
}

// mu N = 0: the border is a point.
TEST_F(ClipConstructed, WithoutFrictionNothingTangentialIsLeft) {
  for (const double brake : {0.0, 5.0}) {
    const ClipAsk ask{{5, -7, 11}, {0, 0, -1}, 0, brake};
    EXPECT_EQ(clip(ask), ClipAnswer(Clipped({Grip::slip, {0, 0, 11}})));
  }
  EXPECT_EQ(clip({{5, -7, 0}, {0, 0, -1}, 3, 100}), ClipAnswer(Clipped({Grip::slip, {0, 0, 0}})));
  EXPECT_EQ(clip({{0, 0, 0}, {3, 0, -4}, 0, 0}), ClipAnswer(Clipped({Grip::stick, {0, 0, 0}})));
}

}  // namespace
}  // namespace groundtruth::properties
