#pragma once
// Convex cells, four half-spaces abreast, and where a range certainly or possibly enters them. Not installed.

#include <cstdint>

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/meeting.hpp>
#include <groundtruth/fast/parts.hpp>
#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

// An ask's range and what bounds the rounding of all that is computed with it.
class Probe {
 public:
  // Of the ask's ends, made in place: a processor waits where what was just written is copied.
  explicit Probe(const EntryAsk& ask) : ends_(ends_of(ask)) {}
  explicit Probe(const RangeEnds& ends) : ends_(ends) {}

  [[gnu::always_inline]] inline const RangeEnds& ends() const { return ends_; }
  [[gnu::always_inline]] inline double greatest_coordinate() const { return greatest_coordinate_; }

  // Lemma clip-interval (proofs-notes/rounding.md): a bound E such that for each half-space of these sizes,
  // with a and b its Deltas at the ends as computed here, w = fl(a - b), both exact Deltas are within E of a
  // and b, and, where |w| > 2 E, its crossing in [0, 1] is within fl(E fl(1/w)) of fl(a fl(1/w)), roundings
  // of the two limits included. It costs 12 u M of rounding and the ends' own error; 17 u and a bit more
  // covers that. 2^-1000 a coordinate makes up for 17 u times a tiny one, which underflows before it meets
  // the normal. Infinite or NaN: nothing is known.
  [[gnu::always_inline]] inline double error_bound(double normal_size, double offset_size) const {
    return normal_size * error_per_normal_ + (0x11p-53 * offset_size + 0x1p-960);
  }

 private:
  RangeEnds ends_;
  double greatest_coordinate_ = ends_.greatest_coordinate();
  double error_per_normal_ =
      0x11p-53 * greatest_coordinate_ + (0x1.01p0 * ends_.coordinate_error + 0x1p-1000);
};

// Largest error bound with which products and quotients of the kernel stay in the range of doubles.
inline constexpr double greatest_usable_error = 0x1p900;

enum class Turn : std::uint8_t { enters, leaves, undecided };

// A half-space of which the range may cross the border: it enters or leaves it at lower <= s <= upper, or
// nothing is known.
struct OpenLeaf {
  double lower = 0;
  double upper = 1;
  std::uint32_t leaf = 0;  // its place in the expression or the cell
  Turn turn = Turn::undecided;
};

using OpenLeaves = boost::container::small_vector<OpenLeaf, 64>;

// Of a half-space with these Deltas at the ends, not certainly of one sign together. Requires Deltas within
// `error`, a usable error bound, of the exact ones.
OpenLeaf open_leaf(std::uint32_t leaf, double delta_at_first, double delta_at_last, double error);

// A leaf, and what is written on it.
struct Face {
  Leaf leaf = no_leaf;
  HalfSpace half_space;
  CellMaterial material;
};

// The half-space of the cell through which the range can enter it, if the meeting knows that it is one alone;
// else no_leaf.
inline Face sole_face(const PackedCells& cells, const Cell& cell, const Meeting& meeting) {
  const std::uint32_t place = meeting.sole_place;
  if (place == no_place) return {};
  return {cells.leaf_at(cell, place), cells.half_space_at(cell, place), cell.material};
}

// Certainly no point of the box lies in the cell.
bool is_apart(const PackedCells& cells, const Cell& cell, const Box& box);

// Appends the half-spaces of the cell inside of which the range does not certainly stay.
void add_open_leaves(const PackedCells& cells, const Cell& cell, const Probe& probe, OpenLeaves& leaves);

}  // namespace groundtruth::fast
