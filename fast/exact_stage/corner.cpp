#include <groundtruth/fast/exact_stage/corner.hpp>

#include <algorithm>

#include <groundtruth/fast/exact_stage/sectors.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

// Places among the leaves that stand, by number.
using Faces = boost::container::small_vector<std::size_t, 64>;

template <class Number>
class Corner {
 public:
  // `normal_of(place)`: a positive multiple of the normal of a leaf of the solid.
  template <class NormalOf>
  Corner(const Standing& standing, NormalOf normal_of) : standing_(standing) {
    for (const std::size_t leaf : standing.leaves()) sides_.push_back(planes_.add(normal_of(leaf)));
  }

  // The first of the candidates that bounds. If all that stand are candidates and none bounds, nothing if the
  // point is interior: lemma one-generic-direction (proofs-notes/faces.md). Else the first candidate.
  std::optional<std::size_t> first_admissible(const Faces& candidates, Arrival arrival) const {
    Outlook outlook{};
    boost::container::small_vector<Side, 16> without_rim;
    for (const std::size_t face : candidates) {
      const Side side = sides_[face];
      if (std::find(without_rim.begin(), without_rim.end(), side) != without_rim.end()) continue;
      outlook = look_from(face);
      if (outlook.bounds) return face;
      if (!outlook.has_rim) without_rim.push_back(side);
    }
    if (arrival == Arrival::starts_there && outlook.has_directions) return std::nullopt;
    return candidates.front();
  }

 private:
  using Side = typename Planes<Number>::Side;
  struct Outlook {
    bool has_rim;  // of the solid, in the face's plane: whatever leaf of this side it is of
    bool bounds;
    bool has_directions;  // outside of all planes
  };
  Outlook look_from(std::size_t face) const {
    Outlook outlook{};
    std::size_t first_line = 0;
    do {
      const SectorView<Number> view(planes_, sides_, face, first_line);
      const View whole = evaluate(view, standing_.expression());
      const Sectors rim = whole.at & ~whole.outward & view.sectors();
      outlook.has_rim |= rim != 0;
      outlook.bounds |= (rim & whole.stands) != 0;
      outlook.has_directions |= (whole.outward & view.sectors()) != 0;
      first_line += most_lines;
    } while (first_line + 1 < planes_.size() && !outlook.bounds);
    return outlook;
  }

  const Standing& standing_;
  Planes<Number> planes_;
  typename SectorView<Number>::Sides sides_;
};

// Enough for determinants of three such normals: six products of three components.
template <std::size_t words>
constexpr int most_bits = (Fixed<words>::bits - 3) / 3;

// Of the normals of the leaves that stand: each one's unit, and how many bits they take in it.
struct NormalUnits {
  boost::container::small_vector<int, 64> units;
  int bits = 0;

  void add(const HalfSpace& leaf) {
    BitRange range;
    range.add(leaf.normal);
    units.push_back(range.lowest());
    bits = std::max(bits, range.bits_above(range.lowest()));
  }
};

template <std::size_t words>
Corner<Fixed<words>> corner_in_words(const Standing& standing, const NormalUnits& normals,
                                     std::span<const HalfSpace> leaves) {
  return {standing, [&, unit = normals.units.begin()](std::size_t leaf) mutable {
            return in_units<words>(leaves[leaf].normal, *unit++);
          }};
}

}  // namespace

std::optional<std::size_t> canonical_leaf(const ExpressionView& solid, const LeavesNearPoint& near,
                                          Arrival arrival) {
  const Standing standing(solid, near);
  if (standing.value() != Truth::open) return std::nullopt;
  const auto& leaves = standing.leaves();
  if (leaves.size() == 1) return leaves.front();
  Faces candidates;
  NormalUnits normals;
  for (std::size_t face = 0; face < leaves.size(); ++face) {
    normals.add(solid.leaves[leaves[face]]);
    if (arrival == Arrival::starts_there || near[leaves[face]] == NearPoint::entered)
      candidates.push_back(face);
  }
  if (!solid.numbers.empty())
    std::sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
      return solid.numbers[leaves[a]] < solid.numbers[leaves[b]];
    });
  const auto face_in = [&](const auto& corner) { return corner.first_admissible(candidates, arrival); };
  const auto face =
      normals.bits <= most_bits<1>   ? face_in(corner_in_words<1>(standing, normals, solid.leaves))
      : normals.bits <= most_bits<2> ? face_in(corner_in_words<2>(standing, normals, solid.leaves))
      : normals.bits <= most_bits<4> ? face_in(corner_in_words<4>(standing, normals, solid.leaves))
                                     : face_in(Corner<Dyadic>(standing, [&](std::size_t leaf) {
                                         return dyadic_normal(solid.leaves[leaf]);
                                       }));
  return face ? std::optional(leaves[*face]) : std::nullopt;
}

}  // namespace groundtruth::fast::exact_stage
