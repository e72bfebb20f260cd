#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/definition/entry_point.hpp>
#include <groundtruth/definition/number.hpp>

#include "random_shapes.hpp"

namespace groundtruth::definition {
namespace {

using namespace test;

template <class Number>
Number distance(const HalfSpace& h, const Triple<Number>& x) {
  return Number(h.normal[0]) * x[0] + Number(h.normal[1]) * x[1] + Number(h.normal[2]) * x[2] -
         Number(h.offset);
}

// With doubles: exact as long as the numbers are as small and whole as those of random_shapes.hpp.
template <class Number>
bool contains(const Shape& shape, const Triple<Number>& x) {
  const auto holds_at_x = [&](const Shape& operand) { return contains(operand, x); };
  if (const auto* h = std::get_if<HalfSpace>(&shape.expression)) return distance(*h, x) <= 0;
  if (const auto* u = std::get_if<Union>(&shape.expression))
    return std::any_of(u->operands.begin(), u->operands.end(), holds_at_x);
  if (const auto* i = std::get_if<Intersection>(&shape.expression))
    return std::all_of(i->operands.begin(), i->operands.end(), holds_at_x);
  return std::holds_alternative<Everything>(shape.expression);
}

std::vector<HalfSpace> leaves(const Shape& shape) {
  if (const auto* h = std::get_if<HalfSpace>(&shape.expression)) return {*h};
  std::vector<Shape> operands;
  if (const auto* u = std::get_if<Union>(&shape.expression)) operands = u->operands;
  if (const auto* i = std::get_if<Intersection>(&shape.expression)) operands = i->operands;
  std::vector<HalfSpace> result;
  for (const Shape& operand : operands)
    for (const HalfSpace& leaf : leaves(operand)) result.push_back(leaf);
  return result;
}

Triple<Rational> at(const EntryAsk& ask, const Rational& lambda) {
  return rational(ask.from) + lambda * (rational(ask.to) - rational(ask.from));
}

// From every crossing in the range, the first whose point the solid contains.
std::optional<Rational> first_by_trying_all(const Shape& shape, const EntryAsk& ask) {
  std::vector<Rational> lambdas{rational(ask.lambda_first)};
  for (const HalfSpace& leaf : leaves(shape)) {
    const Rational a = distance(leaf, rational(ask.from)), b = distance(leaf, rational(ask.to));
    if (a == b) continue;
    const Rational lambda = a / (a - b);
    if (rational(ask.lambda_first) <= lambda && lambda <= rational(ask.lambda_last))
      lambdas.push_back(lambda);
  }
  std::sort(lambdas.begin(), lambdas.end());
  for (const Rational& lambda : lambdas)
    if (contains(shape, at(ask, lambda))) return lambda;
  return std::nullopt;
}

EntryAsk some_ask() {
  EntryAsk ask{some_start(), small_vector(0, 3)};
  if (whole(0, 2) == 0) {
    ask.lambda_first = small(-4, 4) / 4;
    ask.lambda_last = ask.lambda_first + small(0, 8) / 4;
  }
  return ask;
}

EntryFinding find(const Shape& shape, const EntryAsk& ask) {
  return entry_point(Scene(scene_of(shape)), ask);
}

RC_GTEST_PROP(EntryPointLaw, LambdaIsTheFirstMemberOfAllCrossings, ()) {
  const Shape shape = some_solid();
  const EntryAsk ask = some_ask();
  const std::optional<Rational> expected = first_by_trying_all(shape, ask);
  const EntryFinding found = find(shape, ask);
  RC_CLASSIFY(expected && *expected > rational(ask.lambda_first), "entered");
  RC_ASSERT(found.evidence.lambda_exact == (expected ? expected->str() : ""));
  RC_ASSERT(std::holds_alternative<Miss>(found.answer) == !expected);
}

RC_GTEST_PROP(EntryPointLaw, InsideMeansThatAllPointsAroundAreMembers, ()) {
  const Shape shape = some_solid(1);
  const Vector point = small_vector(0, 4);
  const EntryFinding found = find(shape, {point, point});
  if (std::holds_alternative<Miss>(found.answer)) return;
  // Planes with normals of -1, 0, 1 meet in directions of at most 2 a coordinate, three of which span a cell:
  // no cell around the point is without one of these neighbours.
  bool all_around = true;
  for (int x = -6; x <= 6; ++x)
    for (int y = -6; y <= 6; ++y)
      for (int z = -6; z <= 6; ++z)
        all_around = all_around && contains(shape, Vector{point[0] + x * 0x1p-9, point[1] + y * 0x1p-9,
                                                          point[2] + z * 0x1p-9});
  RC_CLASSIFY(all_around, "inside");
  RC_ASSERT(std::holds_alternative<Inside>(found.answer) == all_around);
}

// Face to one side of a solid near a point of it: there are points of the leaf's plane, in no other plane
// through the point, that are members while what lies before them is not. Requires normals of -1, 0, 1.
bool has_free_space_before_it(const Shape& shape, const Triple<Rational>& x, const HalfSpace& face) {
  const Triple<Rational> normal = rational(face.normal);
  const Rational step(1, 1 << 20);
  std::vector<HalfSpace> crossing_planes;
  for (const HalfSpace& leaf : leaves(shape))
    if (distance(leaf, x) == 0 && cross(rational(leaf.normal), normal) != Triple<Rational>{0, 0, 0})
      crossing_planes.push_back(leaf);
  for (int a = -6; a <= 6; ++a)
    for (int b = -6; b <= 6; ++b)
      for (int c = -6; c <= 6; ++c) {
        const Triple<Rational> v{a, b, c};
        const auto holds_v = [&](const HalfSpace& leaf) { return dot(rational(leaf.normal), v) == 0; };
        if (!holds_v(face) || std::any_of(crossing_planes.begin(), crossing_planes.end(), holds_v)) continue;
        const Triple<Rational> on_face = x + step * v;
        if (contains(shape, on_face) && !contains(shape, on_face + step * step * normal)) return true;
      }
  return false;
}

RC_GTEST_PROP(EntryPointLaw, NoAdmissibleFaceIsAGhost, ()) {
  const Shape shape = some_solid(1);
  const EntryAsk ask{some_start(), small_vector(0, 3)};
  const EntryFinding found = find(shape, ask);
  if (!std::holds_alternative<Border>(found.answer)) return;
  const Triple<Rational> x = at(ask, Rational(found.evidence.lambda_exact));
  const std::vector<HalfSpace> all = leaves(shape);
  std::size_t with_free_space = 0;
  for (const Leaf leaf : found.evidence.admissible) {
    RC_ASSERT(distance(all[leaf], x) == 0);
    if (has_free_space_before_it(shape, x, all[leaf])) ++with_free_space;
  }
  const std::size_t count = found.evidence.admissible.size();
  RC_CLASSIFY(with_free_space == count, "on faces");
  RC_CLASSIFY(with_free_space == 0, "on something thinner than a face");
  RC_ASSERT(with_free_space == 0 || with_free_space == count);
}

// The leaves that segments parallel to this one and very near it hit near `lambda`.
std::set<Leaf> hit_near_by(const Scene& scene, const EntryAsk& ask, double lambda) {
  std::set<Leaf> result;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        // Odd numbers of incommensurable steps: no segment lies in a plane through the entry point.
        const auto shifted = [&](const Vector& v) {
          return Vector{v[0] + (2 * x + 1) * 0x1p-20, v[1] + (2 * y + 1) * 0x1.6a09e6p-20,
                        v[2] + (2 * z + 1) * 0x1.bb67aep-20};
        };
        const EntryFinding near = entry_point(scene, {shifted(ask.from), shifted(ask.to)});
        const auto* hit = std::get_if<Border>(&near.answer);
        if (!hit || std::abs(hit->lambda - lambda) > 1e-4) continue;
        result.insert(near.evidence.admissible.begin(), near.evidence.admissible.end());
      }
  return result;
}

// The converse does not hold: in a cavity a face may lie in the shadow of another part from nearby, too.
RC_GTEST_PROP(EntryPointLaw, FacesThatNearbyParallelSegmentsHitAreAdmissible, ()) {
  const Shape shape = some_solid();
  const EntryAsk ask{some_start(), small_vector(0, 3)};
  const EntryFinding found = find(shape, ask);
  const auto* border = std::get_if<Border>(&found.answer);
  RC_CLASSIFY(border && border->lambda > 0, "on a border");
  if (!border || border->lambda == 0) return;
  const std::vector<Leaf>& admissible = found.evidence.admissible;
  const std::set<Leaf> hit = hit_near_by(Scene(scene_of(shape)), ask, border->lambda);
  RC_ASSERT(std::includes(admissible.begin(), admissible.end(), hit.begin(), hit.end()));
}

RC_GTEST_PROP(EntryPointLaw, GrowingOffsetsNeverRaisesLambda, ()) {
  const EntryAsk ask = some_ask();
  const double x = small(-2, 2), y = small(-2, 2), z = small(-2, 2), offset = small(-3, 3);
  const Shape other = some_shape(1);
  const auto with_offset = [&](double d) {
    return first_by_trying_all(any_of({all_of({half_space(x, y, z, d), other})}), ask);
  };
  const EntryFinding grown = find(any_of({all_of({half_space(x, y, z, offset + 0.5), other})}), ask);
  const std::optional<Rational> before = with_offset(offset);
  if (!before) return;
  RC_ASSERT(!grown.evidence.lambda_exact.empty());
  RC_ASSERT(Rational(grown.evidence.lambda_exact) <= *before);
}

RC_GTEST_PROP(EntryPointLaw, ScalingAHalfSpaceChangesNothing, ()) {
  const EntryAsk ask = some_ask();
  const Vector n = small_vector(-2, 2);
  const double offset = small(-3, 3);
  const double factor = std::ldexp(1.0, whole(-900, 900));
  const Shape other = some_shape(1);
  const auto solid = [&](double f) {
    return any_of({all_of({half_space(n[0] * f, n[1] * f, n[2] * f, offset * f), other}), other});
  };
  const EntryFinding plain = find(solid(1), ask), scaled = find(solid(factor), ask);
  RC_ASSERT(scaled.evidence.lambda_exact == plain.evidence.lambda_exact);
  RC_ASSERT(scaled.evidence.admissible == plain.evidence.admissible);
}

}  // namespace
}  // namespace groundtruth::definition
