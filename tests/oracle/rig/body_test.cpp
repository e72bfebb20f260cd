#include <groundtruth/rig/body.hpp>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace groundtruth::rig {
namespace {

double any_number() {
  return *rc::gen::inRange(-1000000, 1000001) * std::ldexp(1.0, *rc::gen::inRange(-30, 5));
}

Eigen::Vector3d any_vector() {
  const double x = any_number(), y = any_number(), z = any_number();
  return {x, y, z};
}

BodyState any_body() {
  BodyState body;
  body.position_in_world = any_vector();
  body.velocity_in_world = any_vector();
  body.angular_velocity_in_world = any_vector();
  const Eigen::Vector3d axis = any_vector();
  body.world_from_body = Eigen::Quaterniond(1 + std::abs(any_number()), axis.x(), axis.y(), axis.z());
  return body;
}

// In the plane y = 0: vectors change the sign of y, axial vectors those of x and z.
Eigen::Vector3d mirrored(const Eigen::Vector3d& v) { return {v.x(), -v.y(), v.z()}; }
Eigen::Vector3d axially_mirrored(const Eigen::Vector3d& v) { return {-v.x(), v.y(), -v.z()}; }
BodyState mirrored(BodyState body) {
  body.position_in_world = mirrored(body.position_in_world);
  body.velocity_in_world = mirrored(body.velocity_in_world);
  body.angular_velocity_in_world = axially_mirrored(body.angular_velocity_in_world);
  body.world_from_body.vec() = axially_mirrored(body.world_from_body.vec());
  return body;
}

bool is_same(const BodyState& a, const BodyState& b) {
  return a.position_in_world == b.position_in_world && a.velocity_in_world == b.velocity_in_world &&
         a.angular_velocity_in_world == b.angular_velocity_in_world &&
         a.world_from_body.coeffs() == b.world_from_body.coeffs();
}

RC_GTEST_PROP(Body, AtRestItKeepsEveryBit, ()) {
  BodyState body = any_body();
  body.velocity_in_world.setZero();
  body.angular_velocity_in_world.setZero();
  BodyState moved = drifted(body, velocities_of(body), 0.1);
  RC_ASSERT(moved.position_in_world == body.position_in_world);
  const BodyState once = moved;
  for (int i = 0; i < 10; ++i) moved = drifted(moved, velocities_of(moved), 0.1);
  RC_ASSERT(is_same(moved, once));  // the first step may have scaled the quaternion, by a power of two
  const Eigen::Matrix3d before = rotation_of(body.world_from_body),
                        after = rotation_of(moved.world_from_body);
  RC_ASSERT(before == after);
}

RC_GTEST_PROP(Body, TheMirroredBodyMovesMirroredToTheBit, ()) {
  const BodyState body = any_body();
  const BodyState image = mirrored(body);
  RC_ASSERT(is_same(drifted(image, velocities_of(image), 0.01),
                    mirrored(drifted(body, velocities_of(body), 0.01))));
}

RC_GTEST_PROP(Body, AccelerationsAreThoseOfTheMassMatrix, ()) {
  const Eigen::Matrix3d rotation = rotation_of(any_body().world_from_body);
  const Machine machine{1200, {1000, 1500, 2000}, {}};
  Vector6 wrench;
  wrench << any_vector(), any_vector();
  const Vector6 back = mass_matrix(machine, rotation) * accelerations(machine, rotation, wrench);
  RC_ASSERT((back - wrench).norm() <= 1e-14 * wrench.norm());
}

TEST(Body, TheQuaternionsLengthDoesNotCount) {
  const Eigen::Quaterniond q(0.5, -0.25, 0.125, 2);
  EXPECT_TRUE(rotation_of(q).isApprox(q.normalized().toRotationMatrix(), 1e-15));
  EXPECT_EQ(rotation_of(Eigen::Quaterniond(q.coeffs() * 1024)), rotation_of(q));
}

TEST(Body, AQuarterTurnIsSecondOrderInTheStep) {
  const auto error = [](int steps) {
    BodyState body;
    body.angular_velocity_in_world = {0, 0, std::acos(0.0)};
    for (int i = 0; i < steps; ++i) body = drifted(body, velocities_of(body), 1.0 / steps);
    return (rotation_of(body.world_from_body).col(0) - Eigen::Vector3d(0, 1, 0)).norm();
  };
  EXPECT_NEAR(error(100) / error(200), 4, 0.01);
  EXPECT_LT(error(200), 1e-4);
}

TEST(Body, ABodyThatDoesNotTurnTakesNoTorque) {
  const Machine machine{2, Eigen::Vector3d::Constant(INFINITY), {}};
  Vector6 wrench;
  wrench << 2, 4, 6, 1e9, 1e9, 1e9;
  Vector6 expected;
  expected << 1, 2, 3, 0, 0, 0;
  EXPECT_EQ(accelerations(machine, Eigen::Matrix3d::Identity(), wrench), expected);
}

TEST(Body, AWheelsFrameMovesWithTheBodyAndSteers) {
  BodyState body;
  body.position_in_world = {10, 0, 0};
  body.angular_velocity_in_world = {0, 0, 2};
  MountedWheel wheel{{}, {3, 0, 0}};
  wheel.steering_share = 0.5;
  Controls controls;
  controls.steering = std::acos(-1.0);
  const Frame frame = frame_of(body, Eigen::Matrix3d::Identity(), wheel, controls);
  EXPECT_EQ(frame.position_in_world, (Vector{13, 0, 0}));
  EXPECT_EQ(frame.velocity_in_world, (Vector{0, 6, 0}));
  EXPECT_TRUE(world_from_wheel(frame).col(0).isApprox(Eigen::Vector3d(0, 1, 0), 1e-15));
}

}  // namespace
}  // namespace groundtruth::rig
