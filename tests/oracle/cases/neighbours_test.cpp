#include <cmath>
#include <limits>
#include <variant>

#include <gtest/gtest.h>

#include <groundtruth/cases/neighbours.hpp>

namespace groundtruth::cases {
namespace {

constexpr int tries = 200;

bool is_next_to(double value, double origin) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool adjacent = value == origin || value == std::nextafter(origin, infinity) ||
                        value == std::nextafter(origin, -infinity);
  return adjacent || (origin == 0 && std::abs(value) == 0x1p-52);
}

bool is_next_to(const Vector& value, const Vector& origin) {
  return is_next_to(value[0], origin[0]) && is_next_to(value[1], origin[1]) &&
         is_next_to(value[2], origin[2]);
}

TEST(NeighbourOfEntry, HasEndsWithinAnUlpAndTheSameRange) {
  const EntryAsk ask{{0, 1, 2.5}, {-3, 0.1, 1e6}, -0.5, 2};
  int moved = 0;
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    const EntryAsk next = neighbour(ask, random);
    EXPECT_TRUE(is_next_to(next.from, ask.from));
    EXPECT_TRUE(is_next_to(next.to, ask.to));
    EXPECT_EQ(next.lambda_first, ask.lambda_first);
    EXPECT_EQ(next.lambda_last, ask.lambda_last);
    moved += next.from != ask.from || next.to != ask.to;
  }
  EXPECT_GT(moved, tries * 9 / 10);
}

TEST(NeighbourOfEntry, OfAPointIsAPoint) {
  const EntryAsk ask{{1, 2, 3}, {1, 2, 3}, 0, 1};
  int moved = 0;
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    const EntryAsk next = neighbour(ask, random);
    EXPECT_EQ(next.from, next.to);
    moved += next.from != ask.from;
  }
  EXPECT_GT(moved, tries / 2);
}

TEST(NeighbourOfClip, KeepsFrictionAndBrakeFromGoingBelowZero) {
  const ClipAsk ask{{3, 4, 5}, {0, 0, -1}, 0, 0, 0.1};
  int more_brake = 0;
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    const ClipAsk next = neighbour(ask, random);
    EXPECT_TRUE(is_next_to(next.force_in_wheel, ask.force_in_wheel));
    EXPECT_TRUE(is_next_to(next.normal_in_wheel, ask.normal_in_wheel));
    EXPECT_GE(next.friction, 0);
    EXPECT_GE(next.brake, 0);
    more_brake += next.brake > 0;
  }
  EXPECT_GT(more_brake, tries / 3);
}

TEST(NeighbourOfStep, MovesFrameAndContactByAnUlpAtMost) {
  StepAsk ask;
  ask.frame.position_in_world = {1, 2, 3};
  ask.brake = 100;
  ask.h = 0.001;
  ask.state = Contact{Grip::slip, {1, 2, 2.5}, {0, 0, 0}, {0, 0, 1}, 0.4, 0.3, 1000.0};
  int moved_frames = 0, moved_pebbles = 0;
  for (std::uint64_t i = 0; i < tries; ++i) {
    Random random(i);
    const StepAsk next = neighbour(ask, random);
    const auto& before = std::get<Contact>(ask.state);
    const auto& contact = std::get<Contact>(next.state);
    EXPECT_TRUE(is_next_to(next.frame.position_in_world, ask.frame.position_in_world));
    EXPECT_TRUE(is_next_to(next.brake, ask.brake));
    EXPECT_TRUE(is_next_to(contact.pebble_in_world, before.pebble_in_world));
    EXPECT_TRUE(is_next_to(contact.normal_in_world, before.normal_in_world));
    EXPECT_TRUE(is_next_to(contact.static_friction, before.static_friction));
    EXPECT_TRUE(is_next_to(contact.dynamic_friction, before.dynamic_friction));
    EXPECT_TRUE(is_next_to(contact.maximum_force.value(), before.maximum_force.value()));
    moved_frames += next.frame.position_in_world != ask.frame.position_in_world;
    moved_pebbles += contact.pebble_in_world != before.pebble_in_world;
  }
  EXPECT_GT(moved_frames, tries / 2);
  EXPECT_GT(moved_pebbles, tries / 2);
}

}  // namespace
}  // namespace groundtruth::cases
