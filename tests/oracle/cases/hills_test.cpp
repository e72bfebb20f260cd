#include <map>
#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases {
namespace {

using testing::delta;
using testing::exactly;
using testing::Rational;

constexpr std::size_t cells = 6;

// The five planes of each prism.
std::vector<std::vector<HalfSpace>> prisms_of(const Scene& scene) {
  const auto& paint = std::get<Painted>(scene.shape.expression);
  std::vector<std::vector<HalfSpace>> prisms;
  for (const Shape& prism : std::get<Union>(paint.over->expression).operands) {
    prisms.push_back(testing::half_spaces_of(prism));
  }
  return prisms;
}

const HalfSpace& top_of(const std::vector<HalfSpace>& prism) { return prism.back(); }

HalfSpace opposite(const HalfSpace& plane) {
  return {{0 - plane.normal[0], 0 - plane.normal[1], 0 - plane.normal[2]}, 0 - plane.offset};
}

// The height of the prism's top above (x, y), if the prism stands there.
std::optional<Rational> height_at(const std::vector<HalfSpace>& prism, double x, double y) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (delta(prism[i], exactly({x, y, 0})) > 0) return std::nullopt;
  }
  const HalfSpace& top = top_of(prism);
  return (Rational(top.offset) - Rational(top.normal[0]) * Rational(x) -
          Rational(top.normal[1]) * Rational(y)) /
         Rational(top.normal[2]);
}

TEST(Hills, HaveTwoPrismsOfFiveLeavesASquare) {
  EXPECT_EQ(leaf_count(hills_of(cells).shape), 2 * cells * cells * 5);
  EXPECT_EQ(prisms_of(hills_of(cells)).size(), 2 * cells * cells);
}

TEST(Hills, EveryInnerSideIsExactlyOppositeToAnotherPrismsSide) {
  const auto prisms = prisms_of(hills_of(cells));
  const double end = 8.0 * cells;
  for (std::size_t p = 0; p < prisms.size(); ++p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const HalfSpace& side = prisms[p][i];
      const bool is_outer = side == HalfSpace{{1, 0, 0}, end} || side == HalfSpace{{0, 1, 0}, end} ||
                            side == HalfSpace{{-1, 0, 0}, 0} || side == HalfSpace{{0, -1, 0}, 0};
      if (is_outer) continue;
      int partners = 0;
      for (std::size_t other = 0; other < prisms.size(); ++other) {
        if (other == p) continue;
        for (std::size_t j = 0; j < 3; ++j) partners += prisms[other][j] == opposite(side);
      }
      EXPECT_GT(partners, 0) << "prism " << p << ", side " << i;
    }
  }
}

TEST(Hills, NeighboursHaveTheSameHeightWhereTheyMeet) {
  const auto prisms = prisms_of(hills_of(cells));
  // Corners, middles of sides and of diagonals of the squares: several prisms stand at each.
  for (double x = 0; x <= 8.0 * cells; x += 4) {
    for (double y = 0; y <= 8.0 * cells; y += 4) {
      std::set<Rational> heights;
      int standing = 0;
      for (const auto& prism : prisms) {
        if (const auto height = height_at(prism, x, y)) {
          heights.insert(*height);
          ++standing;
        }
      }
      EXPECT_GE(standing, 1);
      EXPECT_EQ(heights.size(), 1u) << "at " << x << ", " << y;
    }
  }
}

TEST(Hills, AreNeitherFlatNorWithoutFlatPlaces) {
  int flat = 0;
  std::set<double> offsets;
  const auto prisms = prisms_of(hills_of(20));
  for (const auto& prism : prisms) {
    flat += top_of(prism).normal == Vector{0, 0, 1};
    offsets.insert(top_of(prism).offset);
  }
  EXPECT_GT(flat, 10);
  EXPECT_LT(flat, 400);
  EXPECT_GT(offsets.size(), 50u);
}

}  // namespace
}  // namespace groundtruth::cases
