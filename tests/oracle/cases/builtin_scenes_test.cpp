#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>

#include "exact_checks.hpp"

namespace groundtruth::cases {
namespace {

TEST(BuiltinScenes, HaveTheirDocumentedSizes) {
  const std::map<std::string_view, std::size_t> leaves{{"house", 7},    {"runway", 1200}, {"town", 7001},
                                                       {"hills", 4000}, {"ramp", 17},     {"far-town", 141}};
  for (const auto& [name, count] : leaves) {
    const BuiltinScene* scene = find_builtin_scene(name);
    ASSERT_NE(scene, nullptr) << name;
    const std::vector<Scene> built = scene->build();
    ASSERT_EQ(built.size(), 1u) << name;
    EXPECT_EQ(leaf_count(built[0].shape), count) << name;
  }
}

TEST(BuiltinScenes, AreFoundByNameOnly) {
  for (const BuiltinScene& scene : builtin_scenes()) EXPECT_EQ(find_builtin_scene(scene.name), &scene);
  EXPECT_EQ(find_builtin_scene("castle"), nullptr);
}

// Calls `visit` with every material index in the shape.
void for_each_material(const Shape& shape, const std::function<void(MaterialIndex)>& visit) {
  if (const auto* cover = std::get_if<Covered>(&shape.expression)) {
    visit(cover->material);
    for_each_material(*cover->over, visit);
  } else if (const auto* paint = std::get_if<Painted>(&shape.expression)) {
    visit(paint->material);
    for_each_material(*paint->where, visit);
    for_each_material(*paint->over, visit);
  } else if (const auto* joined = std::get_if<Union>(&shape.expression)) {
    for (const Shape& operand : joined->operands) for_each_material(operand, visit);
  } else if (const auto* met = std::get_if<Intersection>(&shape.expression)) {
    for (const Shape& operand : met->operands) for_each_material(operand, visit);
  }
}

TEST(BuiltinScenes, AreWellFormed) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    for (const Scene& scene : builtin.build()) {
      std::set<std::string> names;
      for (const Material& material : scene.materials) names.insert(material.name);
      EXPECT_EQ(names.size(), scene.materials.size());
      for_each_material(scene.shape, [&](MaterialIndex index) { EXPECT_LT(index, scene.materials.size()); });
      for (const HalfSpace& half_space : testing::half_spaces_of(scene.shape)) {
        EXPECT_TRUE(std::isfinite(half_space.offset)) << builtin.name;
        for (double component : half_space.normal) EXPECT_TRUE(std::isfinite(component)) << builtin.name;
      }
    }
  }
}

// What the pack of degenerate shapes has to contain, whatever else is in it.
TEST(DegeneratePack, HasZeroNormalsOppositePlanesAndEmptyOperands) {
  int zero_normals = 0, opposite_planes = 0, coincident_planes = 0, without_leaves = 0;
  for (const Scene& scene : find_builtin_scene("degenerate")->build()) {
    const std::vector<HalfSpace> planes = testing::half_spaces_of(scene.shape);
    without_leaves += planes.empty();
    for (std::size_t i = 0; i < planes.size(); ++i) {
      zero_normals += planes[i].normal == Vector{};
      for (std::size_t j = i + 1; j < planes.size(); ++j) {
        const Vector& n = planes[j].normal;
        const HalfSpace opposite{{0 - n[0], 0 - n[1], 0 - n[2]}, 0 - planes[j].offset};
        coincident_planes += planes[i] == planes[j];
        opposite_planes += planes[i] == opposite;
      }
    }
  }
  EXPECT_GE(zero_normals, 5);
  EXPECT_GE(opposite_planes, 10);
  EXPECT_GE(coincident_planes, 10);
  EXPECT_GE(without_leaves, 2);
}

TEST(FarTown, LiesAMillionMetresAway) {
  const Scene far = find_builtin_scene("far-town")->build()[0];
  int far_walls = 0;
  for (const HalfSpace& half_space : testing::half_spaces_of(far.shape)) {
    far_walls += half_space.normal == Vector{1, 0, 0} && half_space.offset > 9e5;
  }
  EXPECT_GT(far_walls, 5);
}

}  // namespace
}  // namespace groundtruth::cases
