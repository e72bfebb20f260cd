// Scene and segment moved together, exactly: lambda*, what it is and the admissible leaves stay; so they do
// under every affine map, as "in front of the face" survives those.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/motions.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

void require_unchanged_by(const AffineMap& map, const EntryCase& c) {
  const EntryCase image = map(c);
  const Entered before = Ground(c.shape).entry(c.ask);
  const Entered after = Ground(image.shape).entry(image.ask);
  RC_ASSERT(same_place(after, before));
  RC_ASSERT(after.admissible == before.admissible);
  if (!before.is_border()) return;
  RC_ASSERT(after.border().material == before.border().material);
  const HalfSpace face{before.border().normal_in_world, 0};
  RC_ASSERT(after.border().normal_in_world == map.half_space(face).normal);
}

Dice some_dice() { return Dice(*rc::gen::arbitrary<std::uint64_t>()); }

Vector some_shift(Dice& dice) {
  Vector shift = lattice_vector(dice, 1000);
  for (double& coordinate : shift) coordinate /= 8;
  return shift;
}

RC_GTEST_PROP(EntryMotions, QuarterTurnsAndShifts, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice = some_dice();
  const Quaternion q = quarter_turns(dice);
  const double length = squared_length(q);
  AffineMap map{scaled_rotation(q), some_shift(dice)};
  for (Vector& row : map.matrix)
    for (double& entry : row) entry /= length;
  require_unchanged_by(map, c);
}

// ||q||^2 times a rotation that mixes the axes by rational numbers: 3-4-5 and others.
RC_GTEST_PROP(EntryMotions, RationalRotationsOfAnEnlargedWorld, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice = some_dice();
  const Quaternion q = dice.pick<Quaternion>(
      {{2, 0, 0, 1}, {2, 1, 0, 0}, {1, 0, 2, 0}, {1, 1, 1, 0}, {3, 1, -2, 1}, {1, -1, 2, 4}});
  require_unchanged_by({scaled_rotation(q), some_shift(dice)}, c);
}

RC_GTEST_PROP(EntryMotions, MirrorsAndShears, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice = some_dice();
  const double a = dice.whole(-2, 2), b = dice.whole(-2, 2), side = dice.pick({-1.0, 1.0});
  require_unchanged_by({{{{side, a, 0}, {0, 1, b}, {0, 0, -1}}}, some_shift(dice)}, c);
}

RC_GTEST_PROP(EntryMotions, PowersOfTwo, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice = some_dice();
  const double scale = dice.pick({2.0, 0.5, 0x1p40, 0x1p-40, 0x1p250, 0x1p-250});
  require_unchanged_by({{{{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}}}, {}}, c);
}

// Coordinates of 10^6 m and more with features of a millimetre: nothing is lost to rounding.
RC_GTEST_PROP(EntryMotions, FarFromTheOrigin, ()) {
  const EntryCase c = *lattice_entries();
  Dice dice = some_dice();
  AffineMap map{{{{0x1p-10, 0, 0}, {0, 0x1p-10, 0}, {0, 0, 0x1p-10}}}, {}};
  for (double& coordinate : map.shift) coordinate = dice.whole(-1, 1) * 0x1p22;
  require_unchanged_by(map, c);
}

}  // namespace
}  // namespace groundtruth::properties
