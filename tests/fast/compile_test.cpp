#include <groundtruth/fast/scene.hpp>

#include <gtest/gtest.h>
#include <groundtruth/tests/fast/shapes.hpp>
#include <groundtruth/tests/fast/with_solid.hpp>

namespace groundtruth {
namespace {

// "C[a,b)" a cell, "U(...)" and "I(...)" the operators, "1" everything, "0" nothing.
std::string text(const fast::Node* node) {
  if (node->kind == fast::NodeKind::everything) return "1";
  if (node->kind == fast::NodeKind::nothing) return "0";
  if (node->kind == fast::NodeKind::cell)
    return "C[" + std::to_string(node->first_leaf) + "," + std::to_string(node->end_leaf) + ")";
  std::string operands;
  for (const fast::Node* operand = node + 1; operand != node + node->size; operand += operand->size)
    operands += text(operand);
  return (node->kind == fast::NodeKind::union_of ? "U(" : "I(") + operands + ")";
}

std::string layout(const Shape& shape) {
  const fast::Scene scene = fast::compile_with_solid(Scene{{{"dry", {}, std::nullopt}}, shape});
  EXPECT_EQ(scene.solid().nodes[0].size, scene.solid().nodes.size());
  return text(scene.solid().nodes.data());
}

Shape plane(double offset) { return half_space({1, 0, 0}, offset); }

TEST(FastCompile, MakesAHalfSpaceACell) { EXPECT_EQ(layout(plane(0)), "C[0,1)"); }

TEST(FastCompile, MakesNestedIntersectionsOneCell) {
  EXPECT_EQ(layout(intersect({plane(0), intersect({plane(1), plane(2)}), plane(3)})), "C[0,4)");
}

TEST(FastCompile, JoinsNestedUnionsAndKeepsCellsApart) {
  EXPECT_EQ(layout(unite({plane(0), unite({plane(1), intersect({plane(2), plane(3)})})})),
            "U(C[0,1)C[1,2)C[2,4))");
}

TEST(FastCompile, DoesNotJoinHalfSpacesAcrossAUnion) {
  EXPECT_EQ(layout(intersect({unite({plane(0), plane(1)}), plane(2), plane(3)})), "I(U(C[0,1)C[1,2))C[2,4))");
}

TEST(FastCompile, UnwrapsLoneOperands) {
  EXPECT_EQ(layout(unite({intersect({unite({plane(0)}), plane(1)})})), "C[0,2)");
}

TEST(FastCompile, FoldsConstantsAndEmptyOperators) {
  EXPECT_EQ(layout(unite({{Everything{}}, {Nothing{}}, intersect({})})), "1");
  EXPECT_EQ(layout(unite({})), "0");
  EXPECT_EQ(layout(intersect({plane(0), unite({plane(1), {Everything{}}}), plane(2)})), "I(C[0,1)C[2,3))");
  EXPECT_EQ(layout(unite({plane(0), intersect({plane(1), {Nothing{}}})})), "C[0,1)");
}

TEST(FastCompile, FoldsZeroNormals) {
  EXPECT_EQ(layout(intersect({plane(0), half_space({0, 0, 0}, 1), plane(2)})), "I(C[0,1)C[2,3))");
  EXPECT_EQ(layout(unite({plane(0), intersect({plane(1), half_space({0, 0, 0}, -1)})})), "C[0,1)");
}

TEST(FastCompile, SeesThroughMaterials) {
  EXPECT_EQ(
      layout(intersect({cover(0, plane(0)), paint(0, unite({plane(7), plane(8)}), plane(1)), plane(2)})),
      "C[0,3)");
}

TEST(FastCompile, PutsRegionsApartFromTheSolid) {
  const Shape region = unite({plane(7), cover(0, paint(0, plane(9), plane(8)))});
  const fast::Scene scene = fast::compile_with_solid(
      Scene{{{"dry", {}, std::nullopt}}, unite({paint(0, region, plane(0)), plane(1)})});
  ASSERT_EQ(scene.regions().size(), 1u);
  EXPECT_EQ(text(scene.regions()[0].nodes.data()), "U(C[0,1)C[1,2))");
  EXPECT_EQ(scene.regions()[0].leaves[1].offset, 8);
  EXPECT_EQ(scene.solid().leaves.size(), 2u);
  EXPECT_TRUE(scene.rule_of(0));
  EXPECT_FALSE(scene.rule_of(1));
}

}  // namespace
}  // namespace groundtruth
