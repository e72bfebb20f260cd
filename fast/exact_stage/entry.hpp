#pragma once
// The last stage of an entry ask: Phi (SPEC section 3) on integers, for any doubles at all. Not installed.

#include <cstddef>
#include <optional>
#include <span>

#include <groundtruth/fast/expression.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast::exact_stage {

// A positive expression over some half-spaces: the whole solid, or what is left of it where an ask is
// undecided. `nodes` are laid out as in Expression; cells speak of places in `leaves`.
struct ExpressionView {
  std::span<const Node> nodes;  // the root first; none: nothing
  std::span<const HalfSpace> leaves;
  std::span<const Leaf> numbers;  // of the leaves, by place, distinct; empty: numbered as they stand
};

struct FirstPoint {
  // The canonical leaf's place in `leaves`; absent: the range starts in the interior.
  std::optional<std::size_t> leaf;
  // The place of a leaf that crosses zero at lambda*; absent: lambda* is the range's first.
  std::optional<std::size_t> crossed;
  std::size_t words = 0;  // 64-bit words of the integers that decided; 0: as many as need be
};

// The first point of the range in the solid, exactly; nothing: a miss.
// 1. Hit or miss, interior or border, and the canonical leaf are those of SPEC section 3 for exactly these
//    doubles, subnormal ones and the largest included.
// 2. Where the numbers of the ask are short (some 60, 120 or 250 bits for a normal, a coordinate and a
// range's
//    end together) they are integers of 1, 2 or 4 words, else integers as long as need be.
// 3. Allocates only where an integer needs more than 1,024 bits, for more than some 150 leaves (some 40 where
//    integers are as long as need be), and where more than 64 leaves meet at the point.
// Requires what the ask requires, and of numbers nothing but that they are distinct.
std::optional<FirstPoint> first_point(const ExpressionView& solid, const EntryAsk& ask);

// Does x(lambda*) lie in the expression? lambda* is where the segment's line crosses the plane of
// `crossed` (which requires that it does cross it), without one the range's first.
bool contains(const ExpressionView& region, const EntryAsk& ask, const std::optional<HalfSpace>& crossed);

// lambda where the segment's line crosses the half-space's plane, correctly rounded. Requires that it
// crosses it, and that lambda lies between two doubles.
double crossing(const HalfSpace& half_space, const EntryAsk& ask);

}  // namespace groundtruth::fast::exact_stage
