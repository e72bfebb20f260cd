#pragma once
// Certified boxes around cells. Not installed.

#include <array>
#include <limits>
#include <span>

#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

// low <= x <= high, each coordinate; infinite where nothing is known.
struct Box {
  Vector low{-unbounded, -unbounded, -unbounded};
  Vector high{unbounded, unbounded, unbounded};

  // Certainly no point; requires a box that is certified.
  bool is_empty() const { return low[0] > high[0] || low[1] > high[1] || low[2] > high[2]; }
  bool is_bounded() const;
};

inline constexpr Box nowhere{{unbounded, unbounded, unbounded}, {-unbounded, -unbounded, -unbounded}};

Box hull(const Box& a, const Box& b);
Box intersection(const Box& a, const Box& b);

// Certainly around the half-spaces' intersection, tight but for rounding where at most 16 half-spaces (the
// first ones) bound it. Lemma box-by-duality (proofs-notes/rounding.md): for y >= 0 each x in the cell has
// e.x <= sum y_i d_i + |e - sum y_i n_i|.|x|; what y is does not matter, so it may be computed carelessly.
Box box_around(std::span<const HalfSpace> half_spaces);

// An upper bound of n.x - d over the box; infinite if there is none.
double greatest_delta(const HalfSpace& half_space, const Box& box);

}  // namespace groundtruth::fast
