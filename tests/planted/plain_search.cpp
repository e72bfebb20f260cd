#include "plain_search.hpp"

namespace groundtruth::planted {
namespace {

EntryAnswer answer_of(const std::optional<Hit>& hit, const EntryAsk& ask, const Right& right) {
  if (!hit) return Miss{};
  const double lambda = hit->lambda.top / hit->lambda.bottom;
  if (hit->face == nullptr) return Inside{lambda};
  Leaf leaf = 0;
  while (&std::get<HalfSpace>(right.leaves()[leaf].around.back()->expression) != hit->face) ++leaf;
  const Place from = place(ask.from);
  const Place to = place(ask.to);
  Place point;
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[axis] = from[axis] + Rational(lambda) * (to[axis] - from[axis]);
  return Border{lambda, leaf, hit->face->normal, material_of(right.leaves()[leaf], point)};
}

bool agree(const std::optional<Hit>& a, const std::optional<Hit>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return !(a->lambda < b->lambda) && !(b->lambda < a->lambda) && (a->face == nullptr) == (b->face == nullptr);
}

}  // namespace

std::optional<Hit> PlainSearch::first(const Shape& shape, const Ratio& start) {
  struct Visit {
    PlainSearch& search;
    const Ratio& start;
    std::optional<Hit> operator()(const Everything&) const { return Hit{start}; }
    std::optional<Hit> operator()(const Nothing&) const { return std::nullopt; }
    std::optional<Hit> operator()(const HalfSpace& shape) const {
      if (shape.normal != Vector{}) return search.first_of_half_space(shape, start);
      return shape.offset >= 0 ? std::optional(Hit{start}) : std::nullopt;
    }
    std::optional<Hit> operator()(const Union& shape) const {
      return search.first_of_union(shape.operands, start);
    }
    std::optional<Hit> operator()(const Intersection& shape) const {
      return search.first_of_intersection(shape.operands, start);
    }
    std::optional<Hit> operator()(const Covered& shape) const { return search.first(*shape.over, start); }
    std::optional<Hit> operator()(const Painted& shape) const { return search.first(*shape.over, start); }
  };
  ++visits_;
  return has_given_up() ? std::nullopt : std::visit(Visit{*this, start}, shape.expression);
}

double PlainSearch::distance(const HalfSpace& half_space, const Vector& x) const {
  const Vector& n = half_space.normal;
  return n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - half_space.offset;
}

std::optional<Hit> PlainSearch::first_of_half_space(const HalfSpace& half_space, const Ratio& start) {
  const double near = distance(half_space, ask_.from);
  const double slope = distance(half_space, ask_.to) - near;
  const double at_start = near * start.bottom + slope * start.top;
  if (at_start < 0) return Hit{start};
  if (at_start == 0) return Hit{start, &half_space};
  const Ratio crossing{near, -slope};
  if (!(slope < 0) || last_ < crossing) return std::nullopt;
  if (crossing < start) return Hit{start, &half_space};  // rounding
  return Hit{crossing, &half_space};
}

std::optional<Hit> PlainSearch::first_of_union(std::span<const Shape> operands, const Ratio& start) {
  std::optional<Hit> nearest;
  for (const Shape& operand : operands) {
    const std::optional<Hit> hit = first(operand, start);
    if (!hit) continue;
    if (!nearest || hit->lambda < nearest->lambda) nearest = hit;
    if (hit->face == nullptr && !(nearest->lambda < hit->lambda)) nearest = hit;
  }
  return nearest;
}

std::optional<Hit> PlainSearch::first_of_intersection(std::span<const Shape> operands, const Ratio& start) {
  Hit common{start};
  for (bool moves = true; moves;) {
    moves = false;
    for (const Shape& operand : operands) {
      const std::optional<Hit> hit = first(operand, common.lambda);
      if (!hit) return std::nullopt;
      if (common.lambda < hit->lambda) {
        moves = true;
        common = *hit;
      } else if (common.face == nullptr) {
        common.face = hit->face;
      }
    }
  }
  return common;
}

EntryAnswer deviation(const Right& right, const EntryAsk& ask, PlainSearch& wrong) {
  const Shape& shape = right.scene().shape;
  PlainSearch plain(ask);
  const std::optional<Hit> expected = plain.search(shape);
  const std::optional<Hit> hit = wrong.search(shape);
  const bool is_known = !plain.has_given_up() && !wrong.has_given_up();
  return is_known && !agree(hit, expected) ? answer_of(hit, ask, right) : right.entry(ask);
}

}  // namespace groundtruth::planted
