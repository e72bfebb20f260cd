// Mistakes in the search for the first point.

#include <algorithm>
#include <cmath>
#include <limits>

#include "plain_search.hpp"

namespace groundtruth::planted {
namespace {

class OneRound : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_intersection(std::span<const Shape> operands, const Ratio& start) override {
    Hit common{start};
    for (const Shape& operand : operands) {
      const std::optional<Hit> hit = first(operand, common.lambda);
      if (!hit) return std::nullopt;
      if (common.lambda < hit->lambda || common.face == nullptr) common = *hit;
    }
    return common;
  }
};

class TwoRounds : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_intersection(std::span<const Shape> operands, const Ratio& start) override {
    Hit common{start};
    for (int round = 0; round < 2; ++round) {
      for (const Shape& operand : operands) {
        const std::optional<Hit> hit = first(operand, common.lambda);
        if (!hit) return std::nullopt;
        if (common.lambda < hit->lambda || common.face == nullptr) common = *hit;
      }
    }
    return common;
  }
};

// A union within an intersection stands for the operand that is reached first.
class CommittedUnion : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_intersection(std::span<const Shape> operands, const Ratio& start) override {
    std::vector<Shape> chosen(operands.begin(), operands.end());
    for (Shape& operand : chosen) {
      const auto* united = std::get_if<Union>(&operand.expression);
      if (united == nullptr || united->operands.empty()) continue;
      operand = first_reached(*united, start);
    }
    return without_faces(PlainSearch::first_of_intersection(chosen, start), operands, start);
  }
  Shape first_reached(const Union& united, const Ratio& start) {
    const Shape* best = &united.operands.front();
    std::optional<Hit> nearest;
    for (const Shape& operand : united.operands) {
      const std::optional<Hit> hit = first(operand, start);
      if (!hit || (nearest && !(hit->lambda < nearest->lambda))) continue;
      nearest = hit;
      best = &operand;
    }
    return *best;
  }
  // The chosen operands are copies: the face must be one of the scene's.
  std::optional<Hit> without_faces(std::optional<Hit> hit, std::span<const Shape> operands,
                                   const Ratio& start) {
    const std::optional<Hit> plain = PlainSearch::first_of_intersection(operands, start);
    if (hit) hit->face = plain ? plain->face : nullptr;
    return hit;
  }
};

class FirstOperandWins : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_union(std::span<const Shape> operands, const Ratio& start) override {
    for (const Shape& operand : operands) {
      if (const std::optional<Hit> hit = first(operand, start)) return hit;
    }
    return std::nullopt;
  }
};

class ThickFaces : public PlainSearch {
  using PlainSearch::PlainSearch;
  double distance(const HalfSpace& half_space, const Vector& point) const override {
    const double exact = PlainSearch::distance(half_space, point);
    return std::abs(exact) < 1e-9 ? 0 : exact;
  }
};

class ParallelTolerance : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_half_space(const HalfSpace& half_space, const Ratio& start) override {
    const double near = distance(half_space, ask().from);
    const double slope = distance(half_space, ask().to) - near;
    if (std::abs(slope) < 1e-6 && near > 0) return std::nullopt;
    return PlainSearch::first_of_half_space(half_space, start);
  }
};

// 0 / 0 is not a number, and compares as no hit.
class SlabDivides : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_half_space(const HalfSpace& half_space, const Ratio& start) override {
    const double near = distance(half_space, ask().from);
    if (near == 0 && distance(half_space, ask().to) == 0) return std::nullopt;
    return PlainSearch::first_of_half_space(half_space, start);
  }
};

class FloatDistance : public PlainSearch {
  using PlainSearch::PlainSearch;
  double distance(const HalfSpace& half_space, const Vector& x) const override {
    const auto single = [](double value) { return static_cast<float>(std::clamp(value, -1e37, 1e37)); };
    const Vector& n = half_space.normal;
    float sum = -single(half_space.offset);
    for (std::size_t i = 0; i < 3; ++i) sum += single(n[i]) * single(x[i]);
    return static_cast<double>(sum);
  }
};

class PatientRestart : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_intersection(std::span<const Shape> operands, const Ratio& start) override {
    Hit common{start};
    for (bool moves = true; moves;) {
      moves = false;
      for (const Shape& operand : operands) {
        const std::optional<Hit> hit = first(operand, common.lambda);
        if (!hit) return std::nullopt;
        const Ratio& old = common.lambda;
        moves = moves || hit->lambda.top / hit->lambda.bottom > old.top / old.bottom + 1e-3;
        if (old < hit->lambda || common.face == nullptr) common = *hit;
      }
    }
    return common;
  }
};

// The bounds of axis-parallel planes, in floats rounded to nearest instead of outwards.
class FloatBounds : public PlainSearch {
  using PlainSearch::PlainSearch;
  std::optional<Hit> first_of_union(std::span<const Shape> operands, const Ratio& start) override {
    std::optional<Hit> nearest;
    for (const Shape& operand : operands) {
      if (is_culled(operand)) continue;
      const std::optional<Hit> hit = PlainSearch::first_of_union(std::span(&operand, 1), start);
      if (hit && (!nearest || hit->lambda < nearest->lambda || hit->face == nullptr)) nearest = hit;
    }
    return nearest;
  }
  bool is_culled(const Shape& operand) const {
    const auto* common = std::get_if<Intersection>(&operand.expression);
    if (common == nullptr || ask().lambda_first < 0 || ask().lambda_last > 1) return false;
    return std::any_of(common->operands.begin(), common->operands.end(), [this](const Shape& shape) {
      const auto* half_space = std::get_if<HalfSpace>(&shape.expression);
      return half_space != nullptr && is_beyond(*half_space);
    });
  }
  bool is_beyond(const HalfSpace& half_space) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vector other = half_space.normal;
      const double component = std::exchange(other[axis], 0);
      if (other != Vector{} || std::abs(component) != 1) continue;
      const double bound = static_cast<float>(half_space.offset);
      return std::min(component * ask().from[axis], component * ask().to[axis]) > bound;
    }
    return false;
  }
};

// Looks at 1,000 points of the range only.
EntryAnswer marches(const EntryAsk& ask, const Right& right) {
  constexpr int steps = 1000;
  const EntryAnswer answer = right.entry(ask);
  const auto* border = std::get_if<Border>(&answer);
  const double length = ask.lambda_last - ask.lambda_first;
  if (border == nullptr || !(length > 0) || std::isinf(length)) return answer;
  const double passed = std::floor((border->lambda - ask.lambda_first) / length * steps);
  for (int i = static_cast<int>(passed); i <= steps; ++i) {
    EntryAsk sample = ask;
    sample.lambda_first = sample.lambda_last = ask.lambda_first + length * i / steps;
    if (!std::holds_alternative<Miss>(right.entry(sample))) return answer;
  }
  return Miss{};
}

}  // namespace

std::vector<Bug> search_bugs() {
  using enum Reach;
  constexpr Kind entry = Kind::entry;
  return {
      {"one-round", entry, special, "an intersection is searched in one round", searches<OneRound>()},
      {"two-rounds", entry, special, "an intersection is searched in two rounds: too few around unions",
       searches<TwoRounds>()},
      {"committed-union", entry, special, "a union within an intersection is its first reached operand",
       searches<CommittedUnion>()},
      {"first-operand-wins", entry, common, "a union answers with the first operand that is hit at all",
       searches<FirstOperandWins>()},
      {"thick-faces", entry, extreme, "distances below 1e-9 are 0", searches<ThickFaces>()},
      {"parallel-tolerance", entry, extreme, "a face approached by less than 1e-6 is taken for parallel",
       searches<ParallelTolerance>()},
      {"slab-divides-zero", entry, tied, "0/0: a segment in the plane of a face is outside of it",
       searches<SlabDivides>()},
      {"distances-in-float", entry, common, "distances are computed in float", searches<FloatDistance>()},
      {"restart-tolerance", entry, extreme, "an intersection is not searched again for a move below 1e-3",
       searches<PatientRestart>()},
      {"bounds-in-float", entry, extreme, "boxes are culled by float bounds without padding",
       searches<FloatBounds>()},
      {"marches", entry, special, "marches in 1,000 steps, and passes what is thinner", answers(marches)},
  };
}

}  // namespace groundtruth::planted
