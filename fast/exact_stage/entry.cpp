#include <groundtruth/fast/exact_stage/entry.hpp>

#include <algorithm>

#include <groundtruth/fast/exact_stage/first_point.hpp>
#include <groundtruth/fast/exact_stage/lattice.hpp>
#include <groundtruth/fast/exact_stage/rounding.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

// The ask's segment from the start of its range on: Delta of a leaf is value + t slope, t = lambda - first.
class DyadicSegment {
 public:
  explicit DyadicSegment(const EntryAsk& ask) : ask_(ask) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      direction_[axis] = Dyadic(ask.to[axis]) - ask.from[axis];
      start_[axis] = ask.from[axis] + direction_[axis] * ask.lambda_first;
    }
  }

  Line<DyadicNumbers> line(const HalfSpace& leaf) const {
    const Normal<Dyadic> normal = dyadic_normal(leaf);
    const Dyadic slope = dot(normal, direction_);
    return {dot(normal, start_) - leaf.offset, slope, slope.sign()};
  }
  Dyadic length() const { return Dyadic(ask_.lambda_last) - ask_.lambda_first; }

  // Requires slope != 0.
  double lambda(const Line<DyadicNumbers>& line) const {
    const Dyadic numerator = ask_.lambda_first * line.slope - line.value;
    const auto lambda =
        line.slope_sign > 0 ? nearest_double(numerator, line.slope) : nearest_double(-numerator, -line.slope);
    return *lambda;
  }

 private:
  const EntryAsk& ask_;
  Normal<Dyadic> direction_;
  Normal<Dyadic> start_;
};

std::optional<FirstPoint> first_point_in_dyadics(const ExpressionView& solid, const EntryAsk& ask) {
  const DyadicSegment segment(ask);
  Lines<DyadicNumbers> lines;
  for (const HalfSpace& leaf : solid.leaves) lines.push_back(segment.line(leaf));
  const auto found = find_first_point(DyadicNumbers{}, solid, lines, segment.length());
  if (!found) return std::nullopt;
  const double lambda = found->crossed ? segment.lambda(lines[*found->crossed]) : ask.lambda_first + 0.0;
  return FirstPoint{lambda, found->leaf, found->crossed};
}

std::optional<FirstPoint> first_point_in_machine_integers(const Lattice& lattice, const ExpressionView& solid,
                                                          const EntryAsk& ask) {
  Lines<MachineNumbers> lines;
  for (const HalfSpace& leaf : solid.leaves) lines.push_back(lattice.line(leaf));
  const auto found = find_first_point(MachineNumbers{}, solid, lines, lattice.length());
  if (!found) return std::nullopt;
  const double lambda = found->crossed ? lattice.lambda(lines[*found->crossed]) : ask.lambda_first + 0.0;
  return FirstPoint{lambda, found->leaf, found->crossed};
}

}  // namespace

std::optional<FirstPoint> first_point(const ExpressionView& solid, const EntryAsk& ask) {
  if (const auto lattice = Lattice::of(ask, solid.leaves))
    return first_point_in_machine_integers(*lattice, solid, ask);
  return first_point_in_dyadics(solid, ask);
}

bool contains(const ExpressionView& region, const EntryAsk& ask, const std::optional<HalfSpace>& crossed) {
  if (region.nodes.empty()) return false;
  const DyadicSegment segment(ask);
  Lines<DyadicNumbers> lines;
  for (const HalfSpace& leaf : region.leaves) lines.push_back(segment.line(leaf));
  const Line<DyadicNumbers> place = crossed ? segment.line(*crossed) : Line<DyadicNumbers>{{}, 1.0, 1};
  const DyadicNumbers numbers;
  return Search<DyadicNumbers>(numbers, region, lines).contains(region.nodes.data(), &place);
}

double crossing(const HalfSpace& half_space, const EntryAsk& ask) {
  const DyadicSegment segment(ask);
  return segment.lambda(segment.line(half_space));
}

}  // namespace groundtruth::fast::exact_stage
