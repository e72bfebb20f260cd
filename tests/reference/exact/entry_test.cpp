#include <groundtruth/exact/entry_point.hpp>

#include <gtest/gtest.h>

namespace groundtruth::exact {
namespace {

Shape from(double x) { return {HalfSpace{{-1, 0, 0}, -x}}; }
Shape slab(double x) { return {Intersection{{from(x), {HalfSpace{{1, 0, 0}, x + 1}}}}}; }

// Unions of slabs that never meet, nested in intersections that have to go through all of them: an
// intersection that starts its operands anew at each restart takes 2 to the power of the depth.
Shape restarting(int depth, double base, double end) {
  if (depth == 0) return from(end);
  const double start = base - 8 * depth;
  Shape first{Union{{slab(start + 1), slab(start + 5), from(end)}}};
  Shape second{Union{{restarting(depth - 1, base, end), slab(start + 3), slab(start + 7)}}};
  return {Intersection{{std::move(first), std::move(second)}}};
}

TEST(EntryPoint, RestartsDoNotMultiplyFromLevelToLevel) {
  constexpr int depth = 60;
  const groundtruth::Scene scene{{}, restarting(depth, 8 * depth, 8 * depth + 90)};
  const auto finding = entry_point(Scene(scene), {{0, 0, 0}, {1024, 0, 0}});
  EXPECT_EQ(std::get<Border>(finding.answer).lambda, (8 * depth + 90) / 1024.0);
}

}  // namespace
}  // namespace groundtruth::exact
