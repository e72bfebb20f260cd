#pragma once
// A corner as it is seen from the sectors of a face's plane, many sectors at a time. Not installed.

#include <bit>

#include <groundtruth/fast/evaluate.hpp>
#include <groundtruth/fast/exact_stage/planes.hpp>

namespace groundtruth::fast::exact_stage {

// A set of sectors, bit by bit. Bits 2 i and 2 i + 1: just counterclockwise of the i-th line in which another
// plane cuts this one, in one of its directions and in the other (lemma turned-directions,
// proofs-notes/faces.md).
using Sectors = std::uint64_t;
inline constexpr Sectors all_sectors = ~Sectors{0};
inline constexpr std::size_t most_lines = 32;

// In which sectors something holds of an expression, for directions v of theirs.
struct View {
  Sectors everything;  // with all leaves of other planes replaced by their values at v it is that,
  Sectors nothing;     // or this
  Sectors at;          // v belongs to it
  Sectors outward;     // v, turned a little outward from the face, does
  Sectors stands;      // the face is still there, leaves of other planes replaced
};

template <class Number>
class SectorView {
 public:
  using Value = View;
  using Sides = boost::container::small_vector<typename Planes<Number>::Side, 64>;  // of leaves

  // From the face of leaf `face`; the sectors of its plane's lines with other planes from `first_line` on.
  SectorView(const Planes<Number>& planes, const Sides& sides, std::size_t face, std::size_t first_line)
      : sides_(sides), face_(face), inside_(planes.size()) {
    const std::size_t plane = sides[face].plane;
    const std::size_t lines = std::min(most_lines, planes.size() - 1 - first_line);
    for (std::size_t i = 0; i < lines; ++i) {
      const std::size_t other = first_line + i + (first_line + i >= plane);
      const Normal<Number> line = planes.line(plane, other);
      for (std::size_t third = 0; third < planes.size(); ++third) {
        if (third == plane) continue;
        const int side = planes.side_of(line, plane, other, third);
        inside_[third] |= Sectors{side < 0 ? 1u : 2u} << (2 * i);
      }
    }
    sectors_ = lines == most_lines ? all_sectors : (Sectors{1} << (2 * lines)) - 1;
    if (planes.size() == 1) sectors_ = 1;  // the whole plane
  }

  // The sectors that there are.
  Sectors sectors() const { return sectors_; }

  static View of_none(Operator op) {
    if (op == Operator::union_of) return {0, all_sectors, 0, 0, 0};
    return {all_sectors, 0, all_sectors, all_sectors, 0};
  }
  View of_leaf(std::size_t leaf) const {
    const auto [plane, sense] = sides_[leaf];
    const auto [own_plane, own_sense] = sides_[face_];
    if (plane == own_plane)
      return {0, 0, all_sectors, sense == own_sense ? 0 : all_sectors, leaf == face_ ? all_sectors : 0};
    const Sectors inside = sense > 0 ? inside_[plane] : ~inside_[plane];
    return {inside, ~inside, inside, inside, 0};
  }
  static void join(Operator op, View& all, const View& one) {
    if (op == Operator::union_of) {
      all = {all.everything | one.everything, all.nothing & one.nothing, all.at | one.at,
             all.outward | one.outward, all.stands | one.stands};
      all.stands &= ~all.everything;
    } else {
      all = {all.everything & one.everything, all.nothing | one.nothing, all.at & one.at,
             all.outward & one.outward, all.stands | one.stands};
      all.stands &= ~all.nothing;
    }
  }
  static bool is_settled(Operator op, const View& all) {
    return (op == Operator::union_of ? all.everything : all.nothing) == all_sectors;
  }

 private:
  const Sides& sides_;
  const std::size_t face_;
  boost::container::small_vector<Sectors, 64> inside_;  // of each plane's first leaf
  Sectors sectors_;
};

}  // namespace groundtruth::fast::exact_stage
