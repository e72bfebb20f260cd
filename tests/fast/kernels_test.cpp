// Both variants of the kernels give the same bits, over all doubles.

#include <groundtruth/fast/dispatch.hpp>

#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <groundtruth/fast/clip_decided.hpp>
#include <groundtruth/fast/step_decided.hpp>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth::fast {
namespace {

class AnyNumbers {
 public:
  // Any bits, or within the binades around a size.
  double any() {
    for (;;) {
      const auto x = std::bit_cast<double>(random_());
      if (std::isfinite(x)) return x;
    }
  }
  double near(int exponent) {
    const auto mantissa = std::bit_cast<double>((random_() >> 12) | 0x3ff0000000000000);
    return std::ldexp(random_() % 2 ? mantissa : -mantissa, exponent - static_cast<int>(random_() % 6));
  }
  double some(int exponent) { return random_() % 16 ? near(exponent) : any(); }
  Vector vector(int exponent) { return {some(exponent), some(exponent), some(exponent)}; }
  bool flip() { return random_() % 2 == 0; }

 private:
  std::mt19937_64 random_{3};
};

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

void expect_same_bits(const Vector& a, const Vector& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(bits(a[axis]), bits(b[axis]));
}

class FastKernels : public testing::Test {
 protected:
  void SetUp() override {
    if (best_kernels() == Kernels::portable) GTEST_SKIP() << "this processor has no FMA";
  }
  AnyNumbers numbers;
};

TEST_F(FastKernels, GiveTheSameBitsForClips) {
  std::size_t slips = 0;
  for (int i = 0; i < 20000; ++i) {
    ClipAsk ask{numbers.vector(14), numbers.vector(-3), std::abs(numbers.some(0)),
                std::abs(numbers.some(14))};
    ask.normal_in_wheel[2] = -std::abs(numbers.near(1));
    const ClipAnswer portable = decide_clip(ask, Kernels::portable).answer;
    const ClipAnswer fused = decide_clip(ask, Kernels::fused).answer;
    ASSERT_EQ(portable, fused) << i;
    if (const auto* clipped = std::get_if<Clipped>(&portable)) {
      expect_same_bits(clipped->force_in_wheel, std::get<Clipped>(fused).force_in_wheel);
      slips += clipped->grip == Grip::slip;
    }
  }
  EXPECT_GT(slips, 5000u);
}

TEST_F(FastKernels, GiveTheSameBitsForSteps) {
  const Scene ground =
      compile({{{"dry", {{"rubber", {0.5, 0.25}}}, 1e9}}, cover(0, half_space({0, 0, 1}, 0))});
  std::size_t slips = 0;
  for (int i = 0; i < 10000; ++i) {
    StepAsk ask;
    ask.wheel = {.k_xy = -std::abs(numbers.near(17)),
                 .k_z = -std::abs(numbers.near(17)),
                 .d_xy = -std::abs(numbers.near(10)),
                 .d_z = -std::abs(numbers.near(10)),
                 .z_min = 0.125,
                 .z_zero = 2,
                 .z_max = 3,
                 .tyre = "rubber",
                 .relocation = numbers.flip() ? Relocation::spring : Relocation::return_mapping};
    ask.frame = {{numbers.some(3), numbers.some(3), std::abs(numbers.near(0))},
                 {numbers.near(-4), 1, numbers.near(-4), numbers.near(-4)},
                 numbers.vector(-2),
                 numbers.vector(-4)};
    ask.brake = std::abs(numbers.some(15));
    ask.h = 0.001;
    const Vector& b = ask.frame.position_in_world;
    ask.state = Contact{numbers.flip() ? Grip::slip : Grip::stick,
                        {b[0] + numbers.near(-2), b[1] + numbers.near(-2), 0},
                        numbers.vector(-3),
                        {0, 0, 1},
                        0.5,
                        0.25,
                        {}};
    const StepAnswer portable = decide_step(ground, ask, Kernels::portable).answer;
    const StepAnswer fused = decide_step(ground, ask, Kernels::fused).answer;
    ASSERT_EQ(portable, fused) << i;
    const auto* stepped = std::get_if<Stepped>(&portable);
    if (!stepped) continue;
    const auto& other = std::get<Stepped>(fused);
    expect_same_bits(stepped->force_on_frame_in_world, other.force_on_frame_in_world);
    if (const auto* contact = std::get_if<Contact>(&stepped->state)) {
      expect_same_bits(contact->pebble_in_world, std::get<Contact>(other.state).pebble_in_world);
      expect_same_bits(contact->pebble_velocity_in_world,
                       std::get<Contact>(other.state).pebble_velocity_in_world);
      slips += contact->grip == Grip::slip;
    }
  }
  EXPECT_GT(slips, 1000u);
}

}  // namespace
}  // namespace groundtruth::fast
