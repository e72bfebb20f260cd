// SPEC section 3, monotonicity: the expression is positive, so whatever grows the solid can only lower
// lambda*; a miss counts as plus infinity.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

// `grown` is the answer for the larger solid.
bool never_later(const Entered& grown, const Entered& before) {
  if (before.is_miss()) return true;
  if (grown.is_miss() || *grown.lambda > *before.lambda) return false;
  return !before.is_inside() || grown.is_inside();
}

Shape with_one_leaf_more(const Shape& shape, Leaf leaf, double more) {
  Leaf at = 0;
  return mapped(shape, [&](HalfSpace h) {
    if (at++ == leaf) h.offset += more;
    return h;
  });
}

// mapped() also walks the regions of paints; without paints its order is that of the leaves.
Shape unpainted(const Shape& shape) {
  if (const auto* c = std::get_if<Covered>(&shape.expression)) return unpainted(*c->over);
  if (const auto* p = std::get_if<Painted>(&shape.expression)) return unpainted(*p->over);
  std::vector<Shape> operands = operands_of(shape);
  if (operands.empty()) return shape;
  for (Shape& operand : operands) operand = unpainted(operand);
  return with_operands(shape, std::move(operands));
}

RC_GTEST_PROP(EntryMonotone, GrowingOneOffsetNeverDelaysTheEntry, ()) {
  const EntryCase c = *lattice_entries();
  const Shape shape = unpainted(c.shape);
  const double more = *rc::gen::inRange(1, 9) / 4.0;
  const Entered before = Ground(shape).entry(c.ask);
  for (Leaf leaf = 0; leaf < leaves_of(shape).size(); ++leaf)
    RC_ASSERT(never_later(Ground(with_one_leaf_more(shape, leaf, more)).entry(c.ask), before));
}

RC_GTEST_PROP(EntryMonotone, GrowingAllOffsetsByAnUlpOrMoreNeverDelaysTheEntry, ()) {
  const EntryCase c = *wild_entries();
  Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const Shape grown = mapped(c.shape, [&](HalfSpace h) {
    const double larger = std::fmax(any_double(dice), h.offset);
    h.offset = dice.one_in(2) ? std::nextafter(h.offset, 0x1.fffffffffffffp1023) : larger;
    return h;
  });
  RC_ASSERT(never_later(Ground(grown).entry(c.ask), Ground(c.shape).entry(c.ask)));
}

RC_GTEST_PROP(EntryMonotone, UnitingHastensAndIntersectingDelays, ()) {
  const EntryCase c = *lattice_entries();
  const EntryCase d = *lattice_entries();
  const Entered one = Ground(c.shape).entry(c.ask);
  const Entered other = Ground(d.shape).entry(c.ask);
  const Entered united = Ground(any_of({c.shape, d.shape})).entry(c.ask);
  const Entered intersected = Ground(all_of({c.shape, d.shape})).entry(c.ask);
  RC_ASSERT(never_later(united, one));
  RC_ASSERT(never_later(united, other));
  RC_ASSERT(never_later(one, intersected));
  RC_ASSERT(never_later(other, intersected));
  // The first point of a union is the first point of one of them.
  if (!united.is_miss()) RC_ASSERT(united.lambda == one.lambda || united.lambda == other.lambda);
}

RC_GTEST_PROP(EntryMonotone, WhatLiesFarFromTheSegmentDoesNotMatter, ()) {
  const EntryCase c = *lattice_entries();
  const EntryCase d = *lattice_entries();
  // Coordinates of lattice asks stay below 100 over their ranges.
  const Shape far = all_of({d.shape, half_space(0, 0, -1, -1000)});
  const Shape near = half_space(0, 1, 0, 1000);
  const Ground ground(all_of({any_of({c.shape, far}), near}));
  const Entered alone = Ground(c.shape).entry(c.ask);
  const Entered in_company = ground.entry(c.ask);
  RC_ASSERT(same_place(in_company, alone));
  RC_ASSERT(in_company.admissible == alone.admissible);
}

}  // namespace
}  // namespace groundtruth::properties
