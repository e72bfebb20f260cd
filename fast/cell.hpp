#pragma once
// Convex cells, four half-spaces abreast, and where a range certainly or possibly enters them. Not installed.

#include <cstdint>

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/meeting.hpp>
#include <groundtruth/fast/parts.hpp>
#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

// An ask's range and what bounds the rounding of all that is computed with it.
class Probe {
 public:
  explicit Probe(const RangeEnds& ends)
      : ends_(ends),
        error_per_normal_(0x11p-53 * ends.greatest_coordinate() + 0x1.01p0 * ends.coordinate_error) {}

  const RangeEnds& ends() const { return ends_; }

  // Lemma clip-interval (proofs-notes/rounding.md): a bound E such that for each half-space of these sizes,
  // with a and b its Deltas at the ends as computed here, w = fl(a - b), both exact Deltas are within E of a
  // and b, and, where |w| > 2 E, its crossing in [0, 1] is within fl(E fl(1/w)) of fl(a fl(1/w)), roundings
  // of the two limits included. It costs 12 u M of rounding and the ends' own error; 16 u and a bit more
  // covers that. Infinite or NaN: nothing is known.
  double error_bound(double normal_size, double offset_size) const {
    return normal_size * error_per_normal_ + (0x11p-53 * offset_size + 0x1p-960);
  }

 private:
  RangeEnds ends_;
  double error_per_normal_;
};

// Largest error bound with which products and quotients of the kernel stay in the range of doubles.
inline constexpr double greatest_usable_error = 0x1p900;

enum class Turn : std::uint8_t { enters, leaves, undecided };

// A half-space of which the range may cross the border: it enters or leaves it at lower <= s <= upper, or
// nothing is known.
struct OpenLeaf {
  double lower = 0;
  double upper = 1;
  std::uint32_t leaf = 0;
  Turn turn = Turn::undecided;
};

using OpenLeaves = boost::container::small_vector<OpenLeaf, 64>;

// Of a half-space with these Deltas at the ends, not certainly of one sign together. Requires Deltas within
// `error`, a usable error bound, of the exact ones.
OpenLeaf open_leaf(std::uint32_t leaf, double delta_at_first, double delta_at_last, double error);

Meeting meet(const CellKernels& kernels, const PackedCells& cells, const Cell& cell, const Probe& probe);

// A leaf, and what is written on it.
struct Face {
  Leaf leaf = no_leaf;
  HalfSpace half_space;
  std::uint32_t material = by_rules;  // or whatever is sure of it
};

// The one half-space of the cell through which the range can enter it at `meeting.lower` to
// `meeting.upper`; no_leaf if there may be several or none. Requires a meeting that certainly hits.
Face sole_face(const CellKernels& kernels, const PackedCells& cells, const Cell& cell, const Probe& probe,
               const Meeting& meeting);

// Appends the half-spaces of the cell inside of which the range does not certainly stay.
void add_open_leaves(const PackedCells& cells, const Cell& cell, const Probe& probe, OpenLeaves& leaves);

}  // namespace groundtruth::fast
