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
    for (const std::size_t face : candidates) {
      outlook = look_from(face);
      if (outlook.bounds) return face;
    }
    if (arrival == Arrival::starts_there && outlook.has_directions) return std::nullopt;
    return candidates.front();
  }

 private:
  struct Outlook {
    bool bounds;
    bool has_directions;  // outside of all planes
  };
  Outlook look_from(std::size_t face) const {
    Outlook outlook{};
    std::size_t first_line = 0;
    do {
      const SectorView<Number> view(planes_, sides_, face, first_line);
      const View whole = evaluate(view, standing_.expression());
      outlook.bounds |= (whole.at & ~whole.outward & whole.stands & view.sectors()) != 0;
      outlook.has_directions |= (whole.outward & view.sectors()) != 0;
      first_line += most_lines;
    } while (first_line + 1 < planes_.size() && !outlook.bounds);
    return outlook;
  }

  const Standing& standing_;
  Planes<Number> planes_;
  typename SectorView<Number>::Sides sides_;
};

BitRange bits_of(const HalfSpace& leaf) {
  BitRange bits;
  bits.add(leaf.normal);
  return bits;
}

// Enough for determinants of three such normals: six products of three components.
template <std::size_t words>
constexpr int most_bits = (Fixed<words>::bits - 3) / 3;

template <std::size_t words>
Corner<Fixed<words>> corner_in_words(const Standing& standing, std::span<const HalfSpace> leaves) {
  return {standing, [leaves](std::size_t leaf) {
            return in_units<words>(leaves[leaf].normal, bits_of(leaves[leaf]).lowest());
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
  int bits = 0;
  for (std::size_t face = 0; face < leaves.size(); ++face) {
    const BitRange range = bits_of(solid.leaves[leaves[face]]);
    bits = std::max(bits, range.bits_above(range.lowest()));
    if (arrival == Arrival::starts_there || near[leaves[face]] == NearPoint::entered)
      candidates.push_back(face);
  }
  if (!solid.numbers.empty())
    std::sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
      return solid.numbers[leaves[a]] < solid.numbers[leaves[b]];
    });
  const auto face_in = [&](const auto& corner) { return corner.first_admissible(candidates, arrival); };
  const auto face = bits <= most_bits<1>   ? face_in(corner_in_words<1>(standing, solid.leaves))
                    : bits <= most_bits<2> ? face_in(corner_in_words<2>(standing, solid.leaves))
                    : bits <= most_bits<4> ? face_in(corner_in_words<4>(standing, solid.leaves))
                                           : face_in(Corner<Dyadic>(standing, [&](std::size_t leaf) {
                                               return dyadic_normal(solid.leaves[leaf]);
                                             }));
  return face ? std::optional(leaves[*face]) : std::nullopt;
}

}  // namespace groundtruth::fast::exact_stage
