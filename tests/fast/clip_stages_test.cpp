#include <groundtruth/fast/clip_decided.hpp>

#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <groundtruth/fast/exact_stage/clip.hpp>

namespace groundtruth::fast {
namespace {

constexpr Vector level{0, 0, -1};
const Vector tilted{0.1, -0.2, -0.9};

void expect_stages(const ClipAsk& ask, Stage decisions, Stage force) {
  const DecidedClip got = decide_clip(ask, Kernels::portable);
  EXPECT_EQ(got.decisions, decisions);
  EXPECT_EQ(got.force, force);
  EXPECT_EQ(got.answer, exact_stage::clip(ask));
  if (best_kernels() == Kernels::portable) return;
  const DecidedClip fused = decide_clip(ask, Kernels::fused);
  EXPECT_EQ(fused.decisions, decisions);
  EXPECT_EQ(fused.force, force);
  EXPECT_EQ(fused.answer, got.answer);
}

TEST(FastClipStages, DoublesDecideWhatIsClear) {
  expect_stages({{1, 2, -30}, tilted, 0.5, 5}, Stage::doubles, Stage::none);
  expect_stages({{1, 2, -30}, {1, 0, 0.5}, 0.5, 5}, Stage::doubles, Stage::none);
  expect_stages({{10, 2, -30}, tilted, 0.5, 5}, Stage::doubles, Stage::quick_pair);
  expect_stages({{30, 9, -30}, tilted, 0.5, 5}, Stage::doubles, Stage::quick_pair);
  expect_stages({{20, 90, -30}, tilted, 0.5, 5}, Stage::doubles, Stage::quick_pair);
  expect_stages({{20, 30, -30}, tilted, 0.5, 50}, Stage::doubles, Stage::quick_pair);
}

TEST(FastClipStages, NumbersSmallBesideTheForceAreRoundedInCountedPairs) {
  expect_stages({{10, 0x1p-60, -30}, level, 0.5, 5}, Stage::double_pair, Stage::double_pair);
}

TEST(FastClipStages, SurfacesSteepAcrossTheWheelAreLeftToCountedPairs) {
  expect_stages({{10, 2, -30}, {0, 5, -1}, 0.5, 50}, Stage::double_pair, Stage::double_pair);
}

TEST(FastClipStages, SizesFarFromOneAreLeftToCountedPairs) {
  for (const double size : {0x1p-120, 0x1p120})
    expect_stages({{size, 2 * size, -30 * size}, tilted, 0.5, 5 * size}, Stage::double_pair, Stage::none);
}

TEST(FastClipStages, PairsDecideWhatIsNearABorder) {
  const double above = std::nextafter(4.0, 5.0);
  expect_stages({{3, above, -10}, level, 0.5, 6}, Stage::double_pair, Stage::double_pair);
  expect_stages({{3, std::nextafter(4.0, 3.0), -10}, level, 0.5, 6}, Stage::double_pair, Stage::none);
}

TEST(FastClipStages, BordersAreDecidedExactly) {
  expect_stages({{3, 4, -10}, level, 0.5, 5}, Stage::exact, Stage::exact);
  expect_stages({{9, 4, -10}, level, 0.5, 3}, Stage::exact, Stage::exact);
  expect_stages({{0, 0, 1}, {3, 4, -5}, 1, 1, 1}, Stage::exact, Stage::exact);
}

TEST(FastClipStages, ComponentsThatAreZeroAreQuick) {
  expect_stages({{10, 0, -30}, level, 0.5, 5}, Stage::doubles, Stage::quick_pair);
  expect_stages({{30, 0, -30}, level, 0.5, 50}, Stage::doubles, Stage::quick_pair);
  expect_stages({{0, 30, -30}, level, 0.5, 5}, Stage::doubles, Stage::quick_pair);
  expect_stages({{10, 0, -30}, {0.6, 0, -0.8}, 0.5, 5}, Stage::doubles, Stage::quick_pair);
}

TEST(FastClipStages, WithoutABrakeTheBandIsALine) {
  expect_stages({{0, 3, -10}, level, 0.5, 0}, Stage::doubles, Stage::none);
  expect_stages({{0, 9, -10}, level, 0.5, 0}, Stage::doubles, Stage::quick_pair);
  expect_stages({{0x1p-40, 3, -10}, level, 0.5, 0}, Stage::doubles, Stage::quick_pair);
  expect_stages({{0x1p-40, 9, -10}, level, 0.5, 0}, Stage::doubles, Stage::quick_pair);
  expect_stages({{3, 0, -10}, level, 0.5, 0}, Stage::doubles, Stage::quick_pair);
  expect_stages({{0x1p-60, 3, -10}, level, 0.5, 0}, Stage::double_pair, Stage::double_pair);
  // On the line, but no component shows it.
  expect_stages({{3, 1, -4}, {0.75, 0, -1}, 0.5, 0}, Stage::exact, Stage::exact);
}

TEST(FastClipStages, WithoutFrictionTheDiscIsAPoint) {
  expect_stages({{0, 0, -10}, level, 0, 5}, Stage::doubles, Stage::none);
  expect_stages({{0, 0x1p-40, -10}, level, 0, 5}, Stage::doubles, Stage::quick_pair);
  expect_stages({{3, 4, -10}, level, 0, 5}, Stage::doubles, Stage::quick_pair);
  expect_stages({{3, 4, -10}, level, 0, 0}, Stage::doubles, Stage::quick_pair);
  expect_stages({{3, 4, -10}, tilted, 0, 0}, Stage::doubles, Stage::quick_pair);
  expect_stages({{3, 0, -4}, {0.75, 0, -1}, 0, 5}, Stage::exact, Stage::exact);
}

TEST(FastClipStages, RandomForcesAreQuick) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t quick = 0;
  for (int i = 0; i < 20000; ++i) {
    const ClipAsk ask{{uniform(random), uniform(random), uniform(random)},
                      {0.3 * uniform(random), 0.3 * uniform(random), -1},
                      0.5,
                      std::abs(uniform(random))};
    const DecidedClip got = decide_clip(ask, Kernels::portable);
    quick += got.decisions == Stage::doubles;
    ASSERT_EQ(got.answer, exact_stage::clip(ask));
  }
  EXPECT_GT(quick, 19990u);
}

TEST(FastClipStages, ForcesBetweenDoublesAreRoundedExactly) {
  // The half of 1 + 2^-52 lies between two doubles, and mu N = 1/2 exactly.
  expect_stages({{0, 8, -1 - 0x1p-52}, level, 0x1.8p-1, 0}, Stage::double_pair, Stage::exact);
}

double any_double(std::mt19937_64& random) {
  for (;;) {
    const auto x = std::bit_cast<double>(random());
    if (std::isfinite(x)) return x;
  }
}

TEST(FastClipStages, AgreeOverTheWholeRangeOfDoubles) {
  std::mt19937_64 random(2);
  std::size_t slips = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&] { return any_double(random); };
    // Sizes of one kind together, or everything is too steep and slips by far.
    const double size = any(), normal_size = any();
    const auto near = [&](double x) {
      return std::ldexp(std::ldexp(x, -std::ilogb(x)), std::ilogb(size) + static_cast<int>(random() % 8));
    };
    const auto near_normal = [&](double x) {
      return std::ldexp(std::ldexp(x, -std::ilogb(x)),
                        std::min(1020, std::ilogb(normal_size)) - static_cast<int>(random() % 8));
    };
    const auto finite = [](double x) { return std::isfinite(x) ? x : 1; };
    const ClipAsk ask{{finite(near(any())), finite(near(any())), finite(near(any()))},
                      {near_normal(any()), near_normal(any()), -std::abs(near_normal(any()))},
                      random() % 2 ? 0.5 : std::abs(any()),
                      std::abs(finite(near(any())))};
    const DecidedClip got = decide_clip(ask, Kernels::portable);
    ASSERT_EQ(got.answer, exact_stage::clip(ask)) << i;
    ASSERT_EQ(got.answer, decide_clip(ask).answer) << i;
    const auto* clipped = std::get_if<Clipped>(&got.answer);
    slips += clipped && clipped->grip == Grip::slip;
  }
  EXPECT_GT(slips, 2000u);
}

}  // namespace
}  // namespace groundtruth::fast
