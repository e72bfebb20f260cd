#include <groundtruth/rig/contact_law.hpp>

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::rig {
namespace {

double between(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000 + 1) / 1000.0; }

Eigen::Vector3d any_asked() {
  const double x = between(-10, 10), y = between(-10, 10), z = between(-10, 2);
  return {x, y, z};
}

Border any_border() {
  const double friction = between(0, 2), brake = between(0, 12);
  return {friction, brake};
}

// On a surface whose axes are the wheel's: the clip of the force on the pebble.
std::optional<Vector> clipped_by_the_engine(const Eigen::Vector3d& asked, const Border& border) {
  static const auto ground = implementations::make_engine("exact")->on({{}, {Nothing{}}});
  const ClipAsk ask{{-asked.x(), -asked.y(), -asked.z()}, {0, 0, -1}, border.friction, border.brake};
  const auto answer = ground->answer(ask).answer;
  const auto* clipped = std::get_if<Clipped>(&std::get<ClipAnswer>(answer));
  if (clipped == nullptr) return std::nullopt;
  return clipped->force_in_wheel;
}

RC_GTEST_PROP(Borne, IsTheClipOfTheEngineWhereTheGroundIsPressed, ()) {
  const Eigen::Vector3d asked = any_asked();
  const Border border = any_border();
  RC_PRE(asked.z() < 0);
  const auto clipped = clipped_by_the_engine(asked, border);
  RC_ASSERT(clipped.has_value());
  const Eigen::Vector3d force = borne(asked, border).force;
  for (int i = 0; i < 3; ++i)
    RC_ASSERT(std::abs(force[i] + (*clipped)[static_cast<std::size_t>(i)]) <= 1e-14 * asked.norm());
}

RC_GTEST_PROP(Borne, NeverPullsAndStaysInTheBorder, ()) {
  const Eigen::Vector3d asked = any_asked();
  const Border border = any_border();
  const Eigen::Vector3d force = borne(asked, border).force;
  RC_ASSERT(force.z() <= 0);
  RC_ASSERT(force.z() == std::min(asked.z(), 0.0));
  RC_ASSERT(border_violation(force, {0, 0, -1}, border) <= 1e-15);
}

// Where it has one: both one-sided differences agree.
RC_GTEST_PROP(Borne, ItsDerivativeIsThatOfItsDifferences, ()) {
  const Eigen::Vector3d asked = any_asked();
  const Border border = any_border();
  constexpr double step = 1e-6;
  const BorneForce here = borne(asked, border);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d by = step * Eigen::Vector3d::Unit(axis);
    const Eigen::Vector3d ahead = (borne(asked + by, border).force - here.force) / step;
    const Eigen::Vector3d behind = (here.force - borne(asked - by, border).force) / step;
    if ((ahead - behind).norm() > 1e-4) continue;
    RC_ASSERT((here.derivative.col(axis) - (ahead + behind) / 2).norm() <= 1e-3);
  }
}

RC_GTEST_PROP(BorneByDisc, AgreesWithBorneForTheLoadThatTheDiscIsCutFor, ()) {
  const Eigen::Vector3d asked = any_asked();
  const Border border = any_border();
  RC_PRE(asked.z() < 0);
  const BorneForce one = borne(asked, border);
  const BorneForce other = borne_by_disc(asked, border.friction * -asked.z(), border.brake);
  RC_ASSERT(one.force == other.force);
  RC_ASSERT(other.derivative == other.derivative.transpose());
}

TEST(BorderViolation, IsInPartsOfTheLoad) {
  const Eigen::Vector3d up(0, 0, -1);
  EXPECT_EQ(border_violation({3, 4, -10}, up, {0.5, 100}), 0);
  EXPECT_DOUBLE_EQ(border_violation({3, 4, -10}, up, {0.4, 100}), 0.1) << "beyond the disc";
  EXPECT_DOUBLE_EQ(border_violation({3, 4, -10}, up, {0.5, 1}), 0.2) << "beyond the band";
  EXPECT_EQ(border_violation({3, 4, 10}, up, {0, 0}), 0) << "no load";
}

TEST(ContactLaw, ForcesWhoseSquaresUnderflowAreBorneWithinTheDiscToo) {
  const Eigen::Vector3d force = borne({-5e-297, 1e-297, -6e-312}, {0.5, 1e6}).force;
  EXPECT_NEAR(std::hypot(force.x(), force.y()) / 3e-312, 1, 1e-9);
  EXPECT_LT(force.x(), 0);
}

// In a fast slide: the pebble lies half a metre behind, and the body pitches, rolls and yaws a little.
RC_GTEST_PROP(ContactLaw, ItsSlopeIsThatOfItsDifferences, ()) {
  constexpr double h = 1.0 / 60, width = 1e-6;
  MountedWheel mounted;
  mounted.place_in_body = {-0.4, 1.2, 0.3};
  mounted.wheel = {-1e6, -1e6, -1e4, -1e4, 0.2, 0.8, 0.8, "rubber"};
  const Contact contact{Grip::slip, {-0.9 - between(0, 1) / 2, -1.2, 0}, {}, {0, 0, 1}, 0.5, 0.4, {}};
  const Controls controls;
  const ContactLaw law(mounted, contact, controls, h);
  BodyState body;
  body.world_from_body = {0, 1, between(-1, 1) / 1000, between(-1, 1) / 1000};
  body.position_in_world = {0, 0, 1.09};
  Vector6 velocities;
  velocities << between(20, 60), between(-1, 1), 0, 0, 0, 0;
  const AskedForce at = law.at(drifted(body, velocities, h));
  const Jacobian slope = at.turning - at.stiffness * at.jacobian;
  for (int i = 0; i < 6; ++i) {
    const Vector6 aside = width * Vector6::Unit(i);
    const Eigen::Vector3d difference = law.at(drifted(body, velocities + aside, h)).asked -
                                       law.at(drifted(body, velocities - aside, h)).asked;
    RC_ASSERT((difference / (2 * width) - slope.col(i)).norm() <= 0.01 * slope.norm());
  }
}

}  // namespace
}  // namespace groundtruth::rig
