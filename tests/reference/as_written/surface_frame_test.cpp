#include <groundtruth/as_written/surface_frame.hpp>

#include <gtest/gtest.h>

namespace groundtruth::as_written {
namespace {

constexpr double min_uprightness = 0.1;
const Vector normal{2, 3, -6};  // of length 7

void expect_near(const Vector& got, const Vector& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(got[axis], expected[axis], 1e-15);
  }
}

TEST(SurfaceFrame, ZPointsAgainstTheNormal) {
  expect_near(surface_frame(normal, min_uprightness, {})->z, {-2.0 / 7, -3.0 / 7, 6.0 / 7});
}

TEST(SurfaceFrame, AxesAreOrthonormalAndRightHanded) {
  const Axes axes = *surface_frame(normal, min_uprightness, {});
  expect_near(cross(axes.x, axes.y), axes.z);
  expect_near(cross(axes.y, axes.z), axes.x);
  EXPECT_EQ(axes.x[1], 0);  // it rolls in the wheel's own xz-plane
}

TEST(SurfaceFrameSign, TurnsZToTheMirroredNormal) {
  expect_near(surface_frame(normal, min_uprightness, {Erratum::surface_frame_sign})->z,
              {2.0 / 7, 3.0 / 7, 6.0 / 7});
}

TEST(SurfaceFrame, SurvivesNormalsWhoseSquaresNoDoubleHolds) {
  for (const double size : {1e-320, 1e300}) {
    expect_near(surface_frame({0, 0, -size}, min_uprightness, {})->z, {0, 0, 1});
  }
  // Nearly a wall across y: r = |n_z| alone, and its square is 0.
  expect_near(surface_frame({0, 1, -1e-250}, 1e-300, {})->z, {0, -1, 0});
}

}  // namespace
}  // namespace groundtruth::as_written
