// Any doubles at all: fast need not be right about them yet, but it must answer, and without NaN.

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>
#include <groundtruth/fast/cell.hpp>
#include <groundtruth/fast/clip.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/step.hpp>
#include <groundtruth/tests/fast/shapes.hpp>
#include <groundtruth/tests/fast/with_solid.hpp>

namespace groundtruth {
namespace {

constexpr int rounds = 100000;

class AnyDoubles {
 public:
  explicit AnyDoubles(std::uint64_t seed) : engine_(seed) {}

  std::size_t below(std::size_t end) { return engine_() % end; }
  double any() {
    const double special[] = {
        0, 1, -1, 0x1p-1074, -0x1p-1022, 0x1.fffffffffffffp1023, -0x1.fffffffffffffp1023};
    if (below(4) == 0) return special[below(7)];
    const double value = std::bit_cast<double>(engine_());
    return std::isfinite(value) ? value : 0;
  }
  double positive() {
    const double value = std::abs(any());
    return value > 0 ? value : 1;
  }
  Vector vector() { return {any(), any(), any()}; }
  Shape shape(int depth) {
    if (depth == 0 || below(4) == 0) return half_space(vector(), any());
    std::vector<Shape> operands;
    for (std::size_t count = below(4); count > 0; --count) operands.push_back(shape(depth - 1));
    return below(2) ? unite(operands) : intersect(operands);
  }
  Scene scene() {
    const Friction rubber{positive(), positive()};
    return {{{"m", {{"rubber", rubber}}, std::nullopt}}, cover(0, paint(0, shape(1), shape(3)))};
  }

 private:
  std::mt19937_64 engine_;
};

bool is_finite(const Vector& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

TEST(FastWholeRange, EntryAnswersLieInTheRange) {
  AnyDoubles doubles(1);
  std::size_t hits = 0;
  for (int i = 0; i < rounds; ++i) {
    const Scene written = doubles.scene();
    const fast::Scene scene = fast::compile(written);
    const fast::Expression solid = fast::compile_with_solid(written).solid();
    EntryAsk ask{doubles.vector(), doubles.vector(), doubles.any(), doubles.any()};
    if (ask.lambda_first > ask.lambda_last) std::swap(ask.lambda_first, ask.lambda_last);
    const EntryAnswer answer = fast::entry_point(scene, ask);
    if (const auto* inside = std::get_if<Inside>(&answer)) {
      ASSERT_EQ(inside->lambda, ask.lambda_first);
    }
    if (const auto* border = std::get_if<Border>(&answer)) {
      ++hits;
      ASSERT_TRUE(ask.lambda_first <= border->lambda && border->lambda <= ask.lambda_last) << border->lambda;
      ASSERT_EQ(border->normal_in_world, solid.leaves.at(border->leaf).normal);
    }
  }
  EXPECT_GT(hits, 1000u);
}

TEST(FastWholeRange, ClipAnswersAreFinite) {
  AnyDoubles doubles(2);
  std::size_t slips = 0;
  for (int i = 0; i < rounds; ++i) {
    const ClipAsk ask{doubles.vector(), doubles.vector(), std::abs(doubles.any()), std::abs(doubles.any()),
                      doubles.positive()};
    const ClipAnswer answer = fast::clip(ask);
    const auto* clipped = std::get_if<Clipped>(&answer);
    if (!clipped) continue;
    ASSERT_TRUE(is_finite(clipped->force_in_wheel));
    if (clipped->grip == Grip::slip) ++slips;
  }
  EXPECT_GT(slips, 1000u);
}

TEST(FastWholeRange, StepAnswersAreFinite) {
  AnyDoubles doubles(3);
  std::size_t kinds[3] = {};
  for (int i = 0; i < rounds; ++i) {
    StepAsk ask;
    ask.wheel = {
        -doubles.positive(),      -doubles.positive(),
        -std::abs(doubles.any()), -std::abs(doubles.any()),
        -doubles.positive(),      0,
        doubles.positive(),       "rubber",
        doubles.positive(),       doubles.below(2) ? Relocation::spring : Relocation::return_mapping};
    ask.frame = {doubles.vector(),
                 {doubles.positive(), doubles.any(), doubles.any(), doubles.any()},
                 doubles.vector(),
                 doubles.vector()};
    ask.brake = std::abs(doubles.any());
    ask.h = doubles.positive();
    if (doubles.below(4))
      ask.state = Contact{doubles.below(2) ? Grip::stick : Grip::slip,
                          doubles.vector(),
                          doubles.vector(),
                          doubles.vector(),
                          std::abs(doubles.any()),
                          std::abs(doubles.any()),
                          std::nullopt};
    const StepAnswer answer = fast::step(fast::compile(doubles.scene()), ask);
    ++kinds[answer.index()];
    const auto* stepped = std::get_if<Stepped>(&answer);
    if (!stepped) continue;
    ASSERT_TRUE(is_finite(stepped->force_on_frame_in_world));
    const auto* contact = std::get_if<Contact>(&stepped->state);
    if (!contact) continue;
    ASSERT_TRUE(is_finite(contact->pebble_in_world) && is_finite(contact->pebble_velocity_in_world));
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 0u);
}

// Powers of two change nothing, however large or small: normals, offsets and points scale apart.
TEST(FastWholeRange, LambdaDoesNotDependOnUnits) {
  for (const double length : {0x1p-1000, 0x1p-200, 1.0, 0x1p200, 0x1p1000})
    for (const double weight : {0x1p-70, 1.0, 0x1p20}) {
      const Shape wedge = intersect({half_space({weight, 2 * weight, 0}, 4 * weight * length),
                                     half_space({-weight, 0, weight}, 3 * weight * length)});
      const EntryAsk ask{{9 * length, 1 * length, 0}, {-3 * length, 2 * length, length}};
      const EntryAnswer expected = Border{0.7, 0, {weight, 2 * weight, 0}, std::nullopt};
      EXPECT_EQ(fast::entry_point(fast::compile(Scene{{}, wedge}), ask), expected) << length << " " << weight;
    }
}

// The exact Delta here is -2.7e-27, the computed one 5.2e-26: 17 u times the coordinates, a subnormal, must
// not be rounded to 0 before it meets the normal.
TEST(FastWholeRange, ErrorBoundCoversHugeNormalsAtTinyCoordinates) {
  const Vector normal{0x1.29d645b3e1595p+996, 0x1.c7295d4caa865p+995, -0x1.25b51b954e8d2p+998};
  const Vector x{0x0.039e12b9e8e93p-1022, 0x0.03cf4efaa4c5dp-1022, 0x0.01a7b446d7599p-1022};
  const double computed = normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2];
  EXPECT_GT(computed, 5e-26);
  const fast::Probe probe(fast::RangeEnds{x, x, 0});
  EXPECT_GT(probe.error_bound(std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]), 0), computed);
}

}  // namespace
}  // namespace groundtruth
