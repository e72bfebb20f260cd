// The face rule of both engines against a third reading of SPEC section 3.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/literal_faces.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

RC_GTEST_PROP(LiteralFaces, InteriorAndAdmissibleLeavesAreThoseOfTheRuleWordByWord, ()) {
  const EntryCase c = *cubic_entries();
  const Entered entered = Ground(c.shape).entry(c.ask);
  if (entered.is_miss()) return;
  const LiteralFaces literal = literal_faces(c.shape, c.ask, *entered.lambda);
  RC_ASSERT(entered.is_inside() == literal.interior);
  RC_ASSERT(entered.admissible == literal.admissible);
}

// "No ghost contacts": over the seam of two abutting boxes, and of two half-spaces, is no face but those of
// the top.
TEST(LiteralFaces, TheSeamOfAbuttingBoxesIsNoFace) {
  const Ground boxes(any_of({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}));
  EXPECT_EQ(boxes.entry({{1, 0.5, 2}, {1, 0.5, 0}}).admissible, (std::vector<Leaf>{5, 11}));
  EXPECT_EQ(boxes.entry({{0.5, 0.5, 2}, {1.5, 0.5, 0}}).admissible, (std::vector<Leaf>{5, 11}));
  EXPECT_EQ(boxes.entry({{1.5, 0.5, 2}, {1.5, 0.5, 0}}).admissible, (std::vector<Leaf>{11}));
  EXPECT_TRUE(boxes.entry({{1, 0.5, 0.5}, {1, 0.5, 0.5}}).is_inside());
  const Ground halves(any_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, 0)}));
  EXPECT_TRUE(halves.entry({{0, 0, 0}, {1, 0, 0}}).is_inside());
}

}  // namespace
}  // namespace groundtruth::properties
