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

bool contains_in_dyadics(const ExpressionView& region, const EntryAsk& ask,
                         const std::optional<HalfSpace>& crossed) {
  const DyadicSegment segment(ask);
  Lines<DyadicNumbers> lines;
  for (const HalfSpace& leaf : region.leaves) lines.push_back(segment.line(leaf));
  const Line<DyadicNumbers> place = crossed ? segment.line(*crossed) : Line<DyadicNumbers>{{}, 1.0, 1};
  return contains(DyadicNumbers{}, region, lines, &place);
}

// An ask and some leaves as integers of a fixed length.
class Counted {
 public:
  Counted(const EntryAsk& ask, std::span<const HalfSpace> leaves) : ask_(ask), units_(ask), leaves_(leaves) {
    for (const HalfSpace& leaf : leaves) leaf_units_.push_back(unit_of(leaf));
  }

  // Counts it in as well.
  int unit_of(const HalfSpace& leaf) {
    const Units::OfLeaf of_leaf = units_.of(leaf);
    bits_ = std::max(bits_, of_leaf.bits);
    return of_leaf.unit;
  }

  // Calls one of the two: `in_words` with a lattice of as few words as will do.
  template <class InWords, class InDyadics>
  auto decide(InWords in_words, InDyadics in_dyadics) const {
    const int bits = std::max(bits_, units_.bits());
    if (bits <= Fixed<1>::bits) return in_words(Lattice<1>(ask_, units_));
    if (bits <= Fixed<2>::bits) return in_words(Lattice<2>(ask_, units_));
    if (bits <= Fixed<4>::bits) return in_words(Lattice<4>(ask_, units_));
    return in_dyadics();
  }

  template <std::size_t words>
  Lines<FixedNumbers<words>> lines(const Lattice<words>& lattice) const {
    Lines<FixedNumbers<words>> lines;
    for (std::size_t i = 0; i < leaves_.size(); ++i)
      lines.push_back(lattice.line(leaves_[i], leaf_units_[i]));
    return lines;
  }

 private:
  const EntryAsk& ask_;
  const Units units_;
  const std::span<const HalfSpace> leaves_;
  boost::container::small_vector<int, 256> leaf_units_;
  int bits_ = 0;
};

}  // namespace

std::optional<FirstPoint> first_point(const ExpressionView& solid, const EntryAsk& ask) {
  const Counted counted(ask, solid.leaves);
  const auto in_words = [&]<std::size_t words>(const Lattice<words>& lattice) {
    const auto found =
        find_first_point(FixedNumbers<words>{}, solid, counted.lines(lattice), lattice.length());
    return found ? std::optional(FirstPoint{found->leaf, found->crossed, words}) : std::nullopt;
  };
  return counted.decide(in_words, [&] { return first_point_in_dyadics(solid, ask); });
}

bool contains(const ExpressionView& region, const EntryAsk& ask, const std::optional<HalfSpace>& crossed) {
  Counted counted(ask, region.leaves);
  const int unit = crossed ? counted.unit_of(*crossed) : 0;
  const auto in_words = [&]<std::size_t words>(const Lattice<words>& lattice) {
    const auto lines = counted.lines(lattice);
    const auto place = crossed ? lattice.line(*crossed, unit) : Line<FixedNumbers<words>>{{}, 1, 1};
    return contains(FixedNumbers<words>{}, region, lines, &place);
  };
  return counted.decide(in_words, [&] { return contains_in_dyadics(region, ask, crossed); });
}

double crossing(const HalfSpace& half_space, const EntryAsk& ask) {
  Counted counted(ask, {});
  const int unit = counted.unit_of(half_space);
  const auto by_division =
      counted.decide([&](const auto& lattice) { return lattice.lambda(lattice.line(half_space, unit)); },
                     [] { return std::optional<double>(); });
  if (by_division) return *by_division;
  const DyadicSegment segment(ask);
  return segment.lambda(segment.line(half_space));
}

}  // namespace groundtruth::fast::exact_stage
