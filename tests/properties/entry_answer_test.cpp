// What an entry answer says besides where: lambda's double, the canonical leaf, its normal and material; and
// that "inside" is the topological interior.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

// Whether no other double is closer, nor as close with an even last bit.
bool is_nearest(double value, const Rational& exact) {
  const Rational distance = abs(Rational(Rational(value) - exact));
  for (const double side : {-1.0, 1.0}) {
    const double other = std::nextafter(value, side * std::numeric_limits<double>::infinity());
    if (std::isinf(other)) continue;
    const Rational other_distance = abs(Rational(Rational(other) - exact));
    int exponent = 0;
    const auto last_bit = [&](double x) {
      return std::fmod(std::ldexp(std::frexp(x, &exponent), 53), 2.0) != 0;
    };
    if (other_distance < distance) return false;
    const bool is_normal = std::fabs(value) >= std::numeric_limits<double>::min();
    if (other_distance == distance && is_normal && last_bit(value)) return false;
  }
  return true;
}

RC_GTEST_PROP(EntryAnswer, LambdaIsTheNearestDouble, ()) {
  const EntryCase c = *wild_entries();
  const Entered entered = Ground(c.shape).entry(c.ask);
  if (entered.is_miss()) return;
  const double lambda =
      entered.is_border() ? entered.border().lambda : std::get<Inside>(entered.answer).lambda;
  RC_ASSERT(is_nearest(lambda, *entered.lambda));
}

RC_GTEST_PROP(EntryAnswer, TheLeafIsTheSmallestAdmissibleOneOnItsPlaneWithItsNormalAndMaterial, ()) {
  const EntryCase c = *lattice_entries();
  const Entered entered = Ground(c.shape).entry(c.ask);
  RC_ASSERT(entered.is_border() == !entered.admissible.empty());
  if (!entered.is_border()) return;
  const Border& border = entered.border();
  const std::vector<HalfSpace> leaves = leaves_of(c.shape);
  const Point x = point_at(c.ask, *entered.lambda);
  RC_ASSERT(border.leaf == entered.admissible.front());
  RC_ASSERT(std::is_sorted(entered.admissible.begin(), entered.admissible.end()));
  RC_ASSERT(border.normal_in_world == leaves[border.leaf].normal);
  RC_ASSERT(border.material == material_of(c.shape, border.leaf, x));
  for (const Leaf leaf : entered.admissible) {
    RC_ASSERT(leaves[leaf].normal != Vector{});
    RC_ASSERT(delta(leaves[leaf], x) == 0);
    const bool entering = delta(leaves[leaf], point(c.ask.from)) > delta(leaves[leaf], point(c.ask.to));
    if (*entered.lambda > Rational(c.ask.lambda_first)) RC_ASSERT(entering);
  }
}

// Planes with normals of -1, 0, 1 meet in lines along vectors of at most 2 a coordinate, three of which span
// a cell of space: no cell at the point is without one of these neighbours.
RC_GTEST_PROP(EntryAnswer, InsideMeansThatAllPointsAroundAreMembers, ()) {
  const EntryCase c = *cubic_entries();
  const double place = c.ask.lambda_first;
  const Entered entered = Ground(c.shape).entry({c.ask.from, c.ask.to, place, place});
  if (entered.is_miss()) return;
  const Point centre = point_at(c.ask, Rational(place));
  bool all_around = true;
  for (int k = 0; k < 13 * 13 * 13 && all_around; ++k) {
    Point neighbour = centre;
    neighbour[0] += Rational(k % 13 - 6) / 4096;
    neighbour[1] += Rational(k / 13 % 13 - 6) / 4096;
    neighbour[2] += Rational(k / 169 - 6) / 4096;
    all_around = contains(c.shape, neighbour);
  }
  RC_ASSERT(entered.is_inside() == all_around);
}

RC_GTEST_PROP(EntryAnswer, MaterialsNeverChangeWhereOrWhichFace, ()) {
  const EntryCase c = *lattice_entries();
  const EntryCase other = *lattice_entries();
  const Entered plain = Ground(c.shape).entry(c.ask);
  const Entered all_covered = Ground(covered(2, c.shape)).entry(c.ask);
  const Entered all_painted = Ground(painted(1, {Everything{}}, covered(2, c.shape))).entry(c.ask);
  const Entered not_painted = Ground(painted(1, {Nothing{}}, c.shape)).entry(c.ask);
  const Entered half_painted = Ground(painted(1, other.shape, c.shape)).entry(c.ask);
  RC_ASSERT(not_painted == plain);
  for (const Entered& entered : {all_covered, all_painted, half_painted}) {
    RC_ASSERT(same_place(entered, plain));
    RC_ASSERT(entered.admissible == plain.admissible);
  }
  if (!plain.is_border()) return;
  RC_ASSERT(all_covered.border().material == MaterialIndex{2});
  RC_ASSERT(all_painted.border().material == MaterialIndex{1});
  const bool is_painted = contains(other.shape, point_at(c.ask, *plain.lambda));
  RC_ASSERT(half_painted.border().material == (is_painted ? MaterialIndex{1} : plain.border().material));
}

}  // namespace
}  // namespace groundtruth::properties
