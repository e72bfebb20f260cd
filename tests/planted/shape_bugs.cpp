// Mistakes in reading the expression.

#include <algorithm>
#include <cmath>

#include "rewrite.hpp"
#include "ways.hpp"

namespace groundtruth::planted {
namespace {

using OneChange = Shape (*)(Shape, unsigned depth);

template <OneChange change>
Scene changed(Scene scene) {
  scene.shape = rewritten(scene.shape, change);
  return scene;
}

Shape wide_union_loses_last(Shape shape, unsigned) {
  auto* united = std::get_if<Union>(&shape.expression);
  if (united && united->operands.size() > 8) united->operands.back() = as_nothing(united->operands.back());
  return shape;
}

Shape wide_intersection_loses_last(Shape shape, unsigned) {
  auto* common = std::get_if<Intersection>(&shape.expression);
  if (common && common->operands.size() > 6) common->operands.back() = as_everything(common->operands.back());
  return shape;
}

Shape deep_is_nothing(Shape shape, unsigned depth) { return depth > 8 ? as_nothing(shape) : shape; }

Shape third_union_is_intersection(Shape shape, unsigned depth) {
  const auto* united = std::get_if<Union>(&shape.expression);
  return depth == 3 && united && !united->operands.empty() ? Shape{Intersection{united->operands}} : shape;
}

Shape empty_union_is_everything(Shape shape, unsigned) {
  const auto* united = std::get_if<Union>(&shape.expression);
  return united && united->operands.empty() ? Shape{Everything{}} : shape;
}

Shape empty_intersection_is_nothing(Shape shape, unsigned) {
  const auto* common = std::get_if<Intersection>(&shape.expression);
  return common && common->operands.empty() ? Shape{Nothing{}} : shape;
}

Shape lonely_operand_is_lost(Shape shape, unsigned) {
  const auto* united = std::get_if<Union>(&shape.expression);
  return united && united->operands.size() == 1 ? as_nothing(shape) : shape;
}

Shape union_skips_everything(Shape shape, unsigned) {
  auto* united = std::get_if<Union>(&shape.expression);
  if (united == nullptr) return shape;
  for (Shape& operand : united->operands) {
    if (std::holds_alternative<Everything>(operand.expression)) operand = {Nothing{}};
  }
  return shape;
}

bool has_zero_normal(const Shape& shape) {
  const auto* half_space = std::get_if<HalfSpace>(&shape.expression);
  return half_space != nullptr && half_space->normal == Vector{};
}

Shape zero_normal_is_everything(Shape shape, unsigned) {
  return has_zero_normal(shape) ? as_everything(shape) : shape;
}

Shape zero_normal_is_nothing(Shape shape, unsigned) {
  return has_zero_normal(shape) ? as_nothing(shape) : shape;
}

double squared(const Vector& n) { return n[0] * n[0] + n[1] * n[1] + n[2] * n[2]; }

Shape tiny_normal_is_zero(Shape shape, unsigned) {
  const auto* half_space = std::get_if<HalfSpace>(&shape.expression);
  if (half_space == nullptr || squared(half_space->normal) > 1e-12) return shape;
  return half_space->offset >= 0 ? as_everything(shape) : as_nothing(shape);
}

Shape huge_normal_is_nothing(Shape shape, unsigned) {
  const auto* half_space = std::get_if<HalfSpace>(&shape.expression);
  return half_space && std::isinf(squared(half_space->normal)) ? as_nothing(shape) : shape;
}

bool are_parallel(const HalfSpace& a, const HalfSpace& b) {
  const Numbers u = numbers(a.normal), v = numbers(b.normal);
  return dot(u, v) > 0 && compare(length(cross(u, v)), 0, length(u) * length(v)) == 0;
}

// Of parallel half-spaces of an intersection only the one with the least offset stays, however long its
// normal.
Shape parallels_by_offset(Shape shape, unsigned) {
  auto* common = std::get_if<Intersection>(&shape.expression);
  if (common == nullptr) return shape;
  std::vector<Shape> kept = common->operands;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto* a = std::get_if<HalfSpace>(&common->operands[i].expression);
    if (a == nullptr) continue;
    const bool is_beaten =
        std::any_of(common->operands.begin(), common->operands.end(), [&](const Shape& other) {
          const auto* b = std::get_if<HalfSpace>(&other.expression);
          return b != nullptr && b->offset < a->offset && are_parallel(*a, *b);
        });
    if (is_beaten) kept[i] = as_everything(kept[i]);
  }
  return {Intersection{kept}};
}

float single(double value) { return static_cast<float>(value); }

HalfSpace offset_in_float(HalfSpace half_space) {
  if (std::abs(half_space.offset) < 1e38) half_space.offset = single(half_space.offset);
  return half_space;
}

HalfSpace of_unit_length(HalfSpace half_space) {
  const double length = std::sqrt(squared(half_space.normal));
  if (!(length > 0) || std::isinf(length)) return half_space;
  for (double& component : half_space.normal) component /= length;
  half_space.offset /= length;
  return half_space;
}

Scene with_offsets_in_float(Scene scene) { return with_half_spaces(std::move(scene), offset_in_float); }

// Answers name the normal as it was written.
Prepare normalizes() {
  return [](const Scene& scene) -> Answering {
    const auto as_read = std::make_shared<const Right>(with_half_spaces(scene, of_unit_length));
    return [as_read, written = leaves_of(scene.shape)](const Ask& ask) {
      Answer answer = as_read->answer(ask);
      auto* entry = std::get_if<EntryAnswer>(&answer);
      auto* border = entry ? std::get_if<Border>(entry) : nullptr;
      if (border) border->normal_in_world = written[border->leaf].half_space.normal;
      return answer;
    };
  };
}

}  // namespace

std::vector<Bug> shape_bugs() {
  using enum Reach;
  constexpr Kind entry = Kind::entry;
  return {
      {"wide-union-loses-last", entry, special, "a union of more than 8 operands loses the last",
       reads(changed<wide_union_loses_last>)},
      {"wide-intersection-loses-last", entry, special,
       "an intersection of more than 6 operands loses the last",
       reads(changed<wide_intersection_loses_last>)},
      {"deep-is-nothing", entry, extreme, "what is nested deeper than 8 is nothing",
       reads(changed<deep_is_nothing>)},
      {"third-union-is-intersection", entry, special, "a union at depth 3 is taken for an intersection",
       reads(changed<third_union_is_intersection>)},
      {"empty-union-is-everything", entry, extreme, "the empty union is everything",
       reads(changed<empty_union_is_everything>)},
      {"empty-intersection-is-nothing", entry, extreme, "the empty intersection is nothing",
       reads(changed<empty_intersection_is_nothing>)},
      {"lonely-operand-is-lost", entry, extreme, "a union of one operand is nothing",
       reads(changed<lonely_operand_is_lost>)},
      {"union-skips-everything", entry, extreme, "everything within a union is skipped",
       reads(changed<union_skips_everything>)},
      {"zero-normal-is-everything", entry, extreme, "a zero normal is everything, also for d < 0",
       reads(changed<zero_normal_is_everything>)},
      {"zero-normal-is-nothing", entry, extreme, "a zero normal is nothing, also for d >= 0",
       reads(changed<zero_normal_is_nothing>)},
      {"tiny-normal-is-zero", entry, extreme, "a normal shorter than 1e-6 is zero",
       reads(changed<tiny_normal_is_zero>)},
      {"huge-normal-is-nothing", entry, extreme, "a normal whose square overflows is nothing",
       reads(changed<huge_normal_is_nothing>)},
      {"parallels-by-offset", entry, special, "of parallel half-spaces the least offset wins, unscaled",
       reads(changed<parallels_by_offset>)},
      {"offset-in-float", entry, special, "offsets are kept in float", reads(with_offsets_in_float)},
      {"planes-normalized", entry, special, "planes are brought to unit normals in doubles", normalizes()},
  };
}

}  // namespace groundtruth::planted
