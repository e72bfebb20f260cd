#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases {
namespace {

using testing::delta;
using testing::exactly;
using testing::half_spaces_of;
using testing::Rational;

TEST(House, HasTheSourcesPlanesInItsOrderAndThenAFloor) {
  const std::vector<HalfSpace> expected{{{0, -1, 0}, 4}, {{0, 1, 0}, 4},  {{1, 0, 0}, 3}, {{-1, 0, 0}, 3},
                                        {{1, 0, 1}, 7},  {{-1, 0, 1}, 7}, {{0, 0, -1}, 0}};
  EXPECT_EQ(half_spaces_of(house().shape), expected);
}

TEST(Box, HasTheFacesOfTheContractInItsOrder) {
  const std::vector<HalfSpace> expected{{{-1, 0, 0}, -1}, {{1, 0, 0}, 4},  {{0, -1, 0}, -2},
                                        {{0, 1, 0}, 5},   {{0, 0, -1}, 0}, {{0, 0, 1}, 6}};
  const std::vector<HalfSpace> faces = half_spaces_of(box({1, 2, 0}, {4, 5, 6}));
  EXPECT_EQ(faces, expected);
  EXPECT_FALSE(std::signbit(faces[4].offset));
}

TEST(LeafCount, LeavesOutRegionsOfPaint) {
  const Shape shape =
      painted(wet, box({0, 0, 0}, {1, 1, 1}), union_of({half_space(0, 0, 1, 0), {Nothing{}}}));
  EXPECT_EQ(leaf_count(shape), 1u);
}

TEST(Runway, BoxesAbutAndShareTheirTopPlane) {
  const std::size_t boxes = 5;
  const Scene scene = runway_of(boxes);
  EXPECT_EQ(leaf_count(scene.shape), 6 * boxes);
  std::vector<HalfSpace> faces = half_spaces_of(scene.shape);
  faces.erase(faces.begin(), faces.begin() + 6);  // the patch
  for (std::size_t i = 0; i < boxes; ++i) {
    EXPECT_EQ(faces[6 * i + 5], (HalfSpace{{0, 0, 1}, 0}));
    if (i + 1 == boxes) break;
    EXPECT_EQ(faces[6 * i + 1].offset, -faces[6 * (i + 1)].offset);
  }
}

TEST(Ramp, SlopeMeetsTheFlatGroundInTheLineAtItsFoot) {
  const HalfSpace flat{{0, 0, 1}, 0};
  const HalfSpace slope{{-1, 0, 4}, 0};
  const std::vector<HalfSpace> planes = half_spaces_of(ramp().shape);
  EXPECT_EQ(std::count(planes.begin(), planes.end(), flat), 1);
  EXPECT_EQ(std::count(planes.begin(), planes.end(), slope), 1);
  EXPECT_EQ(leaf_count(ramp().shape), 17u);
  for (double y : {-10.0, 0.0, 10.0})
    EXPECT_EQ(delta(slope, exactly({0, y, 0})), delta(flat, exactly({0, y, 0})));
}

TEST(Town, HasGroundAndSevenPlanesAHouse) {
  EXPECT_EQ(leaf_count(town_of(100, 1).shape), 701u);
  EXPECT_EQ(leaf_count(town_of(0, 1).shape), 1u);
}

TEST(Town, IsTheSameForTheSameSeedOnly) {
  EXPECT_EQ(half_spaces_of(town_of(30, 5).shape), half_spaces_of(town_of(30, 5).shape));
  EXPECT_NE(half_spaces_of(town_of(30, 5).shape), half_spaces_of(town_of(30, 6).shape));
}

TEST(Town, SomeHousesHaveNoMaterialAndSomeNoFrictionForRubber) {
  const Scene town = town_of(32, 1);
  int bare = 0, of_glass = 0;
  for (const Shape& part : std::get<Union>(town.shape.expression).operands) {
    bare += std::holds_alternative<Intersection>(part.expression);
    const auto* cover = std::get_if<Covered>(&part.expression);
    of_glass += cover && cover->material == glass;
  }
  EXPECT_EQ(bare, 2);
  EXPECT_EQ(of_glass, 2);
  EXPECT_EQ(town.materials[glass].friction_by_tyre.count("rubber"), 0u);
}

TEST(GroundMaterials, HaveTheCoefficientsOfTheContract) {
  const std::map<std::string, double> of_rubber{{"dry", 0.4}, {"wet", 0.1}, {"icy", 0.001}, {"dirty", 0.3}};
  const std::vector<Material> materials = ground_materials();
  for (const auto& [name, coefficient] : of_rubber) {
    const auto found = std::find_if(materials.begin(), materials.end(),
                                    [&, wanted = name](const Material& m) { return m.name == wanted; });
    ASSERT_NE(found, materials.end());
    EXPECT_EQ(found->friction_by_tyre.at("rubber"), (Friction{coefficient, coefficient}));
  }
  EXPECT_EQ(materials[water].maximum_force, 0.0);
}

TEST(Nested, IsAsDeepAsAsked) {
  const std::function<unsigned(const Shape&)> depth = [&](const Shape& shape) -> unsigned {
    if (const auto* cover = std::get_if<Covered>(&shape.expression)) return depth(*cover->over);
    if (const auto* paint = std::get_if<Painted>(&shape.expression)) return depth(*paint->over);
    unsigned deepest = 0;
    if (const auto* parts = std::get_if<Union>(&shape.expression)) {
      for (const Shape& part : parts->operands) deepest = std::max(deepest, depth(part));
      return deepest + 1;
    }
    if (const auto* parts = std::get_if<Intersection>(&shape.expression)) {
      for (const Shape& part : parts->operands) deepest = std::max(deepest, depth(part));
      return deepest + 1;
    }
    return 0;
  };
  unsigned deepest = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const unsigned reached = depth(random_nested(seed, 4, 4).shape);
    EXPECT_LE(reached, 5u);  // boxes at the bottom are intersections themselves
    deepest = std::max(deepest, reached);
  }
  EXPECT_EQ(deepest, 5u);
}

TEST(Shifted, MovesExactlyWhatIsMadeOfShortDyadics) {
  const Vector offset{1e6, -1e6, 1e3};
  for (const Scene& scene : {house(), runway_of(4), hills_of(3), ramp()}) {
    const std::vector<HalfSpace> before = half_spaces_of(scene.shape);
    const std::vector<HalfSpace> after = half_spaces_of(shifted(scene, offset).shape);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_EQ(before[i].normal, after[i].normal);
      const Rational moved =
          Rational(before[i].offset) + testing::dot(exactly(before[i].normal), exactly(offset));
      EXPECT_EQ(Rational(after[i].offset), moved);
    }
  }
}

TEST(Shifted, MovesMostOfATownExactly) {
  const Vector offset{1e6, -1e6, 1e3};
  const std::vector<HalfSpace> before = half_spaces_of(town_of(100, 1).shape);
  const std::vector<HalfSpace> after = half_spaces_of(shifted(town_of(100, 1), offset).shape);
  std::size_t exact = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Rational moved =
        Rational(before[i].offset) + testing::dot(exactly(before[i].normal), exactly(offset));
    exact += Rational(after[i].offset) == moved;
  }
  EXPECT_GT(exact, before.size() * 8 / 10);
  EXPECT_LT(exact, before.size());
}

}  // namespace
}  // namespace groundtruth::cases
