#include <algorithm>

#include <gtest/gtest.h>

#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/diagnosis/irrelevance.hpp>

#include "planted_failures.hpp"

namespace groundtruth::diagnosis {
namespace {

using Names = std::vector<std::string>;

TEST(Irrelevance, OnlyTheStartOfTheRangeMatters) {
  const cases::Case failing{
      "", {{}, cases::half_space(0, 0, 1, 0.5)}, EntryAsk{{1, 2, 3}, {1, 2, -3}, 0.25, 0.75}, {}, ""};
  // 0 is the only other value that does not fail.
  EXPECT_EQ(inputs_that_do_not_matter(failing, each(has_range_start)),
            (Names{"from", "to", "range[1]", "leaf 0 normal", "leaf 0 offset"}));
}

TEST(Irrelevance, OfAClipAtTheLimitOnlyTheLimitMatters) {
  const cases::Case failing{"", {{}, {Nothing{}}}, ClipAsk{{1, 2, 4}, {0, 0, -1}, 0.5, 2, 0.1}, {}, ""};
  EXPECT_EQ(inputs_that_do_not_matter(failing, each(has_brake_at_limit)),
            (Names{"force[0]", "force[1]", "normal", "min_uprightness"}));
}

TEST(Irrelevance, OfASlippingWheelOnlyTheTurnMatters) {
  StepAsk ask;
  ask.wheel = {-1, -1, 0, 0, 0, 1, 1, "", 0.1, Relocation::spring};
  ask.h = 1;
  ask.frame.angular_velocity_in_world = {0, 3, 0};
  ask.state = Contact{Grip::slip, {}, {}, {0, 0, 1}, 1, 1, 5.0};
  const cases::Case failing{"", {{}, {Nothing{}}}, ask, {}, ""};
  const Names free = inputs_that_do_not_matter(failing, each(slips_and_turns));
  const auto is_free = [&](const char* name) { return std::ranges::count(free, name) == 1; };
  EXPECT_TRUE(is_free("frame.angular_velocity[0]"));
  EXPECT_FALSE(is_free("frame.angular_velocity[1]"));
  EXPECT_TRUE(is_free("frame.angular_velocity[2]"));
  for (const char* name :
       {"wheel.k_xy", "wheel.d_z", "frame.position", "frame.velocity", "brake", "h", "state.pebble",
        "state.velocity", "state.normal", "state.static", "state.max_force"})
    EXPECT_TRUE(is_free(name)) << name;
}

TEST(Irrelevance, WhatIsNotNamedMatters) {
  const cases::Case failing{
      "", {{}, cases::half_space(0, 0, 1, 0.5)}, EntryAsk{{1, 2, 3}, {1, 2, -3}}, {}, ""};
  EXPECT_EQ(inputs_that_do_not_matter(failing, each([](const cases::Case& with) {
                                        return std::get<EntryAsk>(with.ask).from[2] == 3;
                                      })),
            (Names{"from[0]", "from[1]", "to", "range", "leaf 0 normal", "leaf 0 offset"}));
}

}  // namespace
}  // namespace groundtruth::diagnosis
