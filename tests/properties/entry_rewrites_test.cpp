// Shapes written in other ways. The faces of SPEC section 3 are those of an expression, not of the set of
// points it stands for, so each law says how much of an answer survives, and why.

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/rewrites.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

std::vector<Leaf> renumbered_faces(const Rewritten& rewritten, const Entered& entered) {
  std::vector<Leaf> leaves;
  for (const Leaf leaf : entered.admissible) leaves.push_back(rewritten.old_leaf[leaf]);
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

// Every copy of an admissible leaf is admissible, and nothing else is.
bool admits_the_same(const Rewritten& rewritten, const Entered& after, const Entered& before) {
  std::vector<Leaf> expected;
  for (Leaf leaf = 0; leaf < rewritten.old_leaf.size(); ++leaf) {
    const Leaf old = rewritten.old_leaf[leaf];
    if (std::binary_search(before.admissible.begin(), before.admissible.end(), old)) expected.push_back(leaf);
  }
  return after.admissible == expected;
}

// Neither membership nor "bounds" nor "stands" speaks of an order.
RC_GTEST_PROP(EntryRewrites, PermutingOperandsOnlyRenumbersTheFaces, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const Rewritten permuted = with_operands_permuted(c.shape, dice);
  const Entered before = Ground(c.shape).entry(c.ask);
  const Entered after = Ground(permuted.shape).entry(c.ask);
  RC_ASSERT(same_place(after, before));
  RC_ASSERT(admits_the_same(permuted, after, before));
}

// A copy reduces to what its original reduces to, so it swallows its sibling only where that is swallowed
// anyway: both stand, or neither.
RC_GTEST_PROP(EntryRewrites, DuplicatingOperandsMakesCopiesOfTheFaces, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const Rewritten duplicated = with_operands_duplicated(c.shape, dice);
  const Entered before = Ground(c.shape).entry(c.ask);
  const Entered after = Ground(duplicated.shape).entry(c.ask);
  RC_ASSERT(same_place(after, before));
  RC_ASSERT(admits_the_same(duplicated, after, before));
}

// Constants swallow and vanish alike in a union of unions and in the flat one; leaves keep their numbers.
RC_GTEST_PROP(EntryRewrites, FlatteningChangesNothing, ()) {
  const EntryCase c = *lattice_entries();
  RC_ASSERT(Ground(flattened(c.shape)).entry(c.ask) == Ground(c.shape).entry(c.ask));
}

RC_GTEST_PROP(EntryRewrites, NeutralOperandsAndSingleOperandsChangeNothing, ()) {
  const EntryCase c = *lattice_entries();
  const Entered before = Ground(c.shape).entry(c.ask);
  const Shape nothing{Nothing{}}, everything{Everything{}};
  for (const Shape& shape : {any_of({c.shape}), all_of({c.shape}), any_of({c.shape, nothing}),
                             any_of({any_of({}), c.shape}), all_of({c.shape, everything}),
                             all_of({all_of({}), c.shape}), any_of({all_of({nothing, c.shape}), c.shape})}) {
    const Entered after = Ground(shape).entry(c.ask);
    RC_ASSERT(same_place(after, before));
    RC_ASSERT(after.admissible.size() == before.admissible.size());
  }
}

// n -> 2^k n, d -> 2^k d is the same half-space; the normal is answered as written.
RC_GTEST_PROP(EntryRewrites, ScalingHalfSpacesScalesTheAnsweredNormalOnly, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const Shape scaled = mapped(c.shape, [&dice](HalfSpace h) {
    const double factor = dice.pick({0.5, 1.0, 2.0, 0x1p500, 0x1p-500, 3.0});
    return HalfSpace{{factor * h.normal[0], factor * h.normal[1], factor * h.normal[2]}, factor * h.offset};
  });
  const Entered before = Ground(c.shape).entry(c.ask);
  const Entered after = Ground(scaled).entry(c.ask);
  RC_ASSERT(same_place(after, before));
  RC_ASSERT(after.admissible == before.admissible);
  if (after.is_border())
    RC_ASSERT(after.border().normal_in_world == leaves_of(scaled)[after.border().leaf].normal);
}

// The same set of points: the same lambda*, hit or miss, interior or not. A leaf that bounds or stands in
// A n (B u C) does so in a copy in (A n B) u (A n C), but not only such leaves do: where C is everything, B
// does not stand in A n (B u C), but it does stand in (A n B) u A.
RC_GTEST_PROP(EntryRewrites, DistributingIntersectionOverUnionKeepsThePlaceAndLosesNoFace, ()) {
  const EntryCase a = *lattice_entries();
  const EntryCase b = *lattice_entries();
  const EntryCase c = *lattice_entries();
  const Entered before = Ground(all_of({a.shape, any_of({b.shape, c.shape})})).entry(a.ask);
  const Entered after = Ground(any_of({all_of({a.shape, b.shape}), all_of({a.shape, c.shape})})).entry(a.ask);
  RC_ASSERT(same_place(after, before));
  const Leaf in_a = leaves_of(a.shape).size(), in_b = leaves_of(b.shape).size(),
             in_c = leaves_of(c.shape).size();
  Rewritten distributed;
  distributed.old_leaf.resize(in_a + in_b + in_a + in_c);
  const auto second_a = distributed.old_leaf.begin() + static_cast<std::ptrdiff_t>(in_a + in_b);
  std::iota(distributed.old_leaf.begin(), second_a, Leaf{0});
  std::iota(second_a, second_a + static_cast<std::ptrdiff_t>(in_a), Leaf{0});
  std::iota(second_a + static_cast<std::ptrdiff_t>(in_a), distributed.old_leaf.end(), in_a + in_b);
  const std::vector<Leaf> faces = renumbered_faces(distributed, after);
  RC_ASSERT(std::includes(faces.begin(), faces.end(), before.admissible.begin(), before.admissible.end()));
}

RC_GTEST_PROP(EntryRewrites, ExpressionsOfTheSameSetAreEnteredAtTheSamePlace, ()) {
  const EntryCase a = *lattice_entries();
  const EntryCase b = *lattice_entries();
  const EntryCase c = *lattice_entries();
  const auto& [A, B, C] = std::tie(a.shape, b.shape, c.shape);
  const auto enter = [&](const Shape& shape) { return Ground(shape).entry(a.ask); };
  RC_ASSERT(same_place(enter(any_of({A, all_of({A, B})})), enter(A)));
  RC_ASSERT(same_place(enter(all_of({A, any_of({A, B})})), enter(A)));
  RC_ASSERT(same_place(enter(any_of({A, all_of({B, C})})), enter(all_of({any_of({A, B}), any_of({A, C})}))));
}

}  // namespace
}  // namespace groundtruth::properties
