#include <groundtruth/fast/step_decided.hpp>

#include <random>

#include <gtest/gtest.h>
#include <groundtruth/fast/exact_stage/step.hpp>
#include <groundtruth/fast/step_ground.hpp>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth::fast {
namespace {

fast::Scene ground(Shape shape) {
  const Friction rubber{0.5, 0.25};
  return compile(groundtruth::Scene{{{"dry", {{"rubber", rubber}}, 1e7}}, cover(0, std::move(shape))});
}
fast::Scene flat() { return ground(half_space({0, 0, 1}, 0)); }
fast::Scene runway() {
  std::vector<Shape> boxes;
  for (int i = 0; i < 50; ++i) boxes.push_back(box({1.0 * i, -5, -1}, {i + 1.0, 5, 0}));
  return ground(unite(std::move(boxes)));
}

StepAnswer exactly(const fast::Scene& scene, const StepAsk& ask) {
  SolidAlongStrut along(scene);
  return exact_stage::step(scene, along, ask);
}

void expect_stages(const fast::Scene& scene, const StepAsk& ask, Stage decisions, Stage numbers) {
  for (const Kernels kernels : {Kernels::portable, best_kernels()}) {
    const DecidedStep got = decide_step(scene, ask, kernels);
    EXPECT_EQ(got.decisions, decisions);
    EXPECT_EQ(got.numbers, numbers);
    EXPECT_EQ(got.answer, exactly(scene, ask));
  }
}

// Half a metre above the ground, upside down, not quite level.
StepAsk above_ground() {
  StepAsk ask;
  ask.wheel = {.k_xy = -1e5,
               .k_z = -2e5,
               .d_xy = -1e3,
               .d_z = -1.5e3,
               .z_min = 0.2,
               .z_zero = 0.7,
               .z_max = 0.7,
               .tyre = "rubber"};
  ask.frame.position_in_world = {3.3, 0.2, 0.55};
  ask.frame.world_from_wheel = {0.01, 1, 0.02, -0.03};
  ask.frame.velocity_in_world = {1.1, 0.1, -0.2};
  ask.brake = 300;
  ask.h = 0.001;
  return ask;
}

StepAsk in_contact(Vector pebble) {
  StepAsk ask = above_ground();
  ask.state = Contact{Grip::slip, pebble, {0.1, 0.2, 0}, {0, 0, 1}, 0.5, 0.25, 1e7};
  return ask;
}

TEST(FastStepStages, OrdinaryStepsAreQuick) {
  expect_stages(flat(), above_ground(), Stage::doubles, Stage::quick_pair);
  expect_stages(flat(), in_contact({3.3, 0.2, 0}), Stage::doubles, Stage::quick_pair);
  expect_stages(runway(), in_contact({3.5, 0.3, 0}), Stage::doubles, Stage::quick_pair);
}

TEST(FastStepStages, EachClippingIsQuickWithEitherRelocation) {
  for (const Relocation relocation : {Relocation::spring, Relocation::return_mapping})
    for (const double brake : {0.0, 300.0, 1e5})
      for (const double across : {0.001, 0.01, 0.3}) {
        StepAsk ask = in_contact({3.2, 0.2 + across, 0});
        ask.wheel.relocation = relocation;
        ask.brake = brake;
        expect_stages(flat(), ask, Stage::doubles, Stage::quick_pair);
      }
}

TEST(FastStepStages, PlanesSquareToNoAxisAreQuick) {
  expect_stages(ground(half_space({0.1, -0.05, 1}, 0.2)), above_ground(), Stage::doubles, Stage::quick_pair);
  StepAsk ask = in_contact({3.2, 0.3, -0.1});
  std::get<Contact>(ask.state).normal_in_world = {0.1, -0.05, 1};
  expect_stages(ground(half_space({0.1, -0.05, 1}, 0.2)), ask, Stage::doubles, Stage::quick_pair);
}

// A wheel that stands straight: some numbers are 0, which a bound for the whole ask never shows.
TEST(FastStepStages, WheelsThatStandStraightAreQuick) {
  const Quaternion along_x{0, 1, 0, 0}, along_y{0, 0.7, 0.7, 0}, pitched_along_y{0.14, 0.7, 0.7, -0.14};
  for (const Relocation relocation : {Relocation::spring, Relocation::return_mapping})
    for (const double brake : {0.0, 300.0, 1e5})
      for (const double pull : {0.001, 0.3}) {
        StepAsk ask = in_contact({3.3 + pull, 0.2, 0});
        ask.wheel.relocation = relocation;
        ask.brake = brake;
        ask.frame.world_from_wheel = along_x;
        ask.frame.velocity_in_world = {1.1, 0, -0.2};
        std::get<Contact>(ask.state).pebble_velocity_in_world = {};
        expect_stages(flat(), ask, Stage::doubles, Stage::quick_pair);
        for (const Quaternion& orientation : {along_y, pitched_along_y}) {
          ask.frame.world_from_wheel = orientation;
          ask.frame.position_in_world = {0, 3.3, 0.55};
          ask.frame.velocity_in_world = {0, 1.1, -0.2};
          std::get<Contact>(ask.state).pebble_in_world = {0, 3.3 + pull, 0};
          expect_stages(flat(), ask, Stage::doubles, Stage::quick_pair);
        }
      }
}

TEST(FastStepStages, WheelsAboveTheOriginAreQuick) {
  StepAsk ask = above_ground();
  ask.frame.world_from_wheel = {0, 1, 0, 0};
  ask.frame.position_in_world = {0, 0, 0.55};
  expect_stages(flat(), ask, Stage::doubles, Stage::quick_pair);
}

TEST(FastStepStages, PulledAsideByNextToNothingIsLeftToCountedPairs) {
  StepAsk ask = in_contact({3.3, 0, 0});
  ask.frame.position_in_world[1] = 0x1p-60;
  ask.frame.world_from_wheel = {0, 1, 0, 0};
  ask.frame.velocity_in_world = {1.1, 0x1p-60, -0.2};
  std::get<Contact>(ask.state).pebble_velocity_in_world = {};
  expect_stages(flat(), ask, Stage::double_pair, Stage::double_pair);
}

// The load is 5 (2^51 - 1) 2^-37, an odd number of 54 bits.
TEST(FastStepStages, TiesOfFewBitsNeedNoExactStage) {
  for (const double brake : {0.0, 300.0, 1e5}) {
    StepAsk ask = in_contact({3.3125, 0, 0});
    ask.brake = brake;
    ask.frame.position_in_world = {3, 0, 0.5 + 0x1p-53};
    ask.frame.world_from_wheel = {0, 1, 0, 0};
    ask.frame.velocity_in_world = {};
    ask.wheel.k_z = -0x5p16;
    ask.wheel.z_zero = 0.75;
    ask.wheel.z_max = 0.75;
    std::get<Contact>(ask.state).pebble_velocity_in_world = {};
    expect_stages(flat(), ask, Stage::double_pair, Stage::double_pair);
  }
}

TEST(FastStepStages, LimitsAreDecidedExactly) {
  StepAsk ask = above_ground();
  ask.frame.world_from_wheel = {0, 1, 0, 0};
  ask.wheel.z_min = 0.25;
  ask.wheel.z_zero = ask.wheel.z_max = 0.75;
  for (const double height : {0.25, 0.75}) {
    ask.frame.position_in_world[2] = height;
    expect_stages(flat(), ask, Stage::exact, Stage::exact);
  }
  StepAsk pressed = in_contact({3.3, 0.2, 0});
  pressed.frame = ask.frame;
  pressed.frame.velocity_in_world = {};
  pressed.wheel = ask.wheel;
  pressed.wheel.d_xy = pressed.wheel.d_z = 0;
  pressed.frame.position_in_world = {3.3, 0.2, 0.5};
  std::get<Contact>(pressed.state).maximum_force = 5e4;
  expect_stages(flat(), pressed, Stage::exact, Stage::exact);
}

TEST(FastStepStages, NearALimitPairsDecide) {
  StepAsk ask = in_contact({3.3, 0.2, 0});
  ask.frame.world_from_wheel = {0, 1, 0, 0};
  ask.wheel.z_max = ask.wheel.z_zero = 0.55;
  ask.frame.position_in_world[2] = std::nextafter(0.55, 1);
  expect_stages(flat(), ask, Stage::double_pair, Stage::double_pair);
}

TEST(FastStepStages, ASeamIsLookedAtExactly) {
  StepAsk ask = above_ground();
  ask.frame.world_from_wheel = {0, 1, 0, 0};
  ask.frame.position_in_world[0] = 3;
  expect_stages(runway(), ask, Stage::exact, Stage::exact);
}

class RandomSteps {
 public:
  explicit RandomSteps(std::uint64_t seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Exact often enough for ties.
  double near(double low, double high) {
    const double x = between(low, high);
    return random_() % 4 ? x : std::round(x * 8) / 8;
  }
  Vector vector(double size) { return {near(-size, size), near(-size, size), near(-size, size)}; }

  StepAsk ask() {
    StepAsk ask = above_ground();
    ask.wheel.relocation = random_() % 2 ? Relocation::spring : Relocation::return_mapping;
    ask.wheel.d_xy = -near(0, 2000);
    ask.frame.position_in_world = {near(2, 40), near(-4, 4), near(0.1, 0.9)};
    ask.frame.world_from_wheel = {near(-0.2, 0.2), near(-1, 1), near(-1, 1), near(-0.2, 0.2)};
    if (ask.frame.world_from_wheel[1] == 0) ask.frame.world_from_wheel[1] = 1;
    if (random_() % 4 == 0) {  // over a seam of the runway
      ask.frame.world_from_wheel = {0, 1, 0, 0};
      ask.frame.position_in_world[0] = std::round(ask.frame.position_in_world[0]);
    }
    ask.frame.velocity_in_world = vector(2);
    ask.frame.angular_velocity_in_world = vector(1);
    ask.brake = near(0, 4000);
    if (random_() % 4 == 0) return ask;
    const Vector& b = ask.frame.position_in_world;
    ask.state = Contact{random_() % 2 ? Grip::stick : Grip::slip,
                        {b[0] + near(-0.1, 0.1), b[1] + near(-0.1, 0.1), 0},
                        vector(1),
                        random_() % 2 ? Vector{0, 0, 1} : Vector{near(-0.5, 0.5), 0.25, 1},
                        0.5,
                        0.25,
                        1e7};
    return ask;
  }

 private:
  std::mt19937_64 random_;
};

TEST(FastStepStages, AgreeWithTheExactOne) {
  RandomSteps steps(1);
  const fast::Scene scene = runway();
  std::size_t counts[5] = {};
  for (int i = 0; i < 6000; ++i) {
    const StepAsk ask = steps.ask();
    const DecidedStep got = decide_step(scene, ask, Kernels::portable);
    ++counts[static_cast<std::size_t>(got.decisions)];
    ASSERT_EQ(got.answer, exactly(scene, ask)) << i;
    ASSERT_EQ(got.answer, decide_step(scene, ask).answer) << i;
  }
  EXPECT_GT(counts[static_cast<std::size_t>(Stage::doubles)], 3000u);
  EXPECT_GT(counts[static_cast<std::size_t>(Stage::exact)], 10u);
}

}  // namespace
}  // namespace groundtruth::fast
