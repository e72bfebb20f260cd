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
  return found ? std::optional(FirstPoint{found->leaf, found->crossed, 0}) : std::nullopt;
}

template <std::size_t words>
std::optional<FirstPoint> first_point_in_words(const Units& units, const ExpressionView& solid,
                                               const EntryAsk& ask) {
  const Lattice<words> lattice(ask, units);
  Lines<FixedNumbers<words>> lines;
  for (const HalfSpace& leaf : solid.leaves) lines.push_back(lattice.line(leaf));
  const auto found = find_first_point(FixedNumbers<words>{}, solid, lines, lattice.length());
  return found ? std::optional(FirstPoint{found->leaf, found->crossed, words}) : std::nullopt;
}

bool contains_in_dyadics(const ExpressionView& region, const EntryAsk& ask,
                         const std::optional<HalfSpace>& crossed) {
  const DyadicSegment segment(ask);
  Lines<DyadicNumbers> lines;
  for (const HalfSpace& leaf : region.leaves) lines.push_back(segment.line(leaf));
  const Line<DyadicNumbers> place = crossed ? segment.line(*crossed) : Line<DyadicNumbers>{{}, 1.0, 1};
  return contains(DyadicNumbers{}, region, lines, &place);
}

template <std::size_t words>
bool contains_in_words(const Units& units, const ExpressionView& region, const EntryAsk& ask,
                       const std::optional<HalfSpace>& crossed) {
  const Lattice<words> lattice(ask, units);
  Lines<FixedNumbers<words>> lines;
  for (const HalfSpace& leaf : region.leaves) lines.push_back(lattice.line(leaf));
  const auto place = crossed ? lattice.line(*crossed) : Line<FixedNumbers<words>>{{}, 1, 1};
  return contains(FixedNumbers<words>{}, region, lines, &place);
}

int most_bits(const Units& units, std::span<const HalfSpace> leaves) {
  int bits = units.bits();
  for (const HalfSpace& leaf : leaves) bits = std::max(bits, units.bits(leaf));
  return bits;
}

}  // namespace

std::optional<FirstPoint> first_point(const ExpressionView& solid, const EntryAsk& ask) {
  const Units units(ask);
  const int bits = most_bits(units, solid.leaves);
  if (bits <= Fixed<1>::bits) return first_point_in_words<1>(units, solid, ask);
  if (bits <= Fixed<2>::bits) return first_point_in_words<2>(units, solid, ask);
  if (bits <= Fixed<4>::bits) return first_point_in_words<4>(units, solid, ask);
  return first_point_in_dyadics(solid, ask);
}

bool contains(const ExpressionView& region, const EntryAsk& ask, const std::optional<HalfSpace>& crossed) {
  const Units units(ask);
  const int bits = std::max(most_bits(units, region.leaves), crossed ? units.bits(*crossed) : 0);
  if (bits <= Fixed<1>::bits) return contains_in_words<1>(units, region, ask, crossed);
  if (bits <= Fixed<2>::bits) return contains_in_words<2>(units, region, ask, crossed);
  if (bits <= Fixed<4>::bits) return contains_in_words<4>(units, region, ask, crossed);
  return contains_in_dyadics(region, ask, crossed);
}

double crossing(const HalfSpace& half_space, const EntryAsk& ask) {
  const Units units(ask);
  if (units.bits(half_space) <= Fixed<2>::bits) {
    const Lattice<2> lattice(ask, units);
    if (const auto lambda = lattice.lambda(lattice.line(half_space))) return *lambda;
  }
  const DyadicSegment segment(ask);
  return segment.lambda(segment.line(half_space));
}

}  // namespace groundtruth::fast::exact_stage
