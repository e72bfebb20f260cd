#pragma once
// A range against the squares of a grid. Not installed.

#include <algorithm>

#include <groundtruth/fast/grid.hpp>
#include <groundtruth/fast/lanes.hpp>
#include <groundtruth/fast/range_ends.hpp>

namespace groundtruth::fast {

// Both limits belong to it.
struct Squares {
  std::uint32_t first_column, last_column, first_row, last_row;

  std::size_t count() const {
    return std::size_t{last_column - first_column + 1} * (last_row - first_row + 1);
  }
};

// A longer range is better served by the hierarchy.
inline bool is_served(const Grid& grid, const Squares& squares) {
  constexpr std::size_t most_squares = 6;
  return grid.rows > 0 && squares.count() <= most_squares;
}

// Places in a square are monotone, so that what lies beyond another there does so in space.
struct SquareProbe {
  std::uint8_t first_across, last_across, first_along, last_along;
  double low, high;

  // One branch, not six that nobody can foretell.
  [[gnu::always_inline]] inline bool reaches(const GridEntry& entry) const {
    const int across = (entry.first_across <= last_across) & (entry.last_across >= first_across);
    const int along = (entry.first_along <= last_along) & (entry.last_along >= first_along);
    const int upward = (double{entry.low} <= high) & (double{entry.high} >= low);
    return (across & along & upward) != 0;
  }
};

// The box around a range, grown by what rounding did to its ends: across and along abreast. The same
// operations as Grid's, hence the same places. Requires a grid.
class GridProbe {
 public:
  GridProbe(const Grid& grid, const RangeEnds& ends) {
    const Pair first = pair(ends.first[grid.across], ends.first[grid.along]);
    const Pair last = pair(ends.last[grid.across], ends.last[grid.along]);
    const Pair margin = Pair::all(2 * ends.coordinate_error), per_metre = Pair::all(grid.per_metre);
    const Pair origin = pair(grid.origin_across, grid.origin_along);
    first_ = (lesser(first, last) - margin - origin) * per_metre;
    last_ = (greater(first, last) + margin - origin) * per_metre;
    last_square_ = pair(grid.columns - 1, grid.rows - 1);
    const double one = ends.first[grid.upward], other = ends.last[grid.upward];
    low_ = std::min(one, other) - 2 * ends.coordinate_error;
    high_ = std::max(one, other) + 2 * ends.coordinate_error;
  }

  Squares squares() const {
    const Whole first = whole(lesser(greater(first_, Pair::all(0)), last_square_));
    const Whole last = whole(lesser(greater(last_, Pair::all(0)), last_square_));
    return {first.across, last.across, first.along, last.along};
  }

  // The part of it that concerns one square.
  SquareProbe in_square(std::uint32_t column, std::uint32_t row) const {
    const Pair square = pair(column, row);
    const Whole first = part_of_square(first_ - square), last = part_of_square(last_ - square);
    return {static_cast<std::uint8_t>(first.across),
            static_cast<std::uint8_t>(last.across),
            static_cast<std::uint8_t>(first.along),
            static_cast<std::uint8_t>(last.along),
            low_,
            high_};
  }

 private:
  using Pair = OneVector<TwoDoubles>;
  struct Whole {
    std::uint32_t across, along;
  };

  static Pair pair(double across, double along) { return {V2d{across, along}}; }
  static Whole whole(Pair x) { return {static_cast<std::uint32_t>(x[0]), static_cast<std::uint32_t>(x[1])}; }
  static Whole part_of_square(Pair place) {
    return whole(lesser(greater(place * Pair::all(256), Pair::all(0)), Pair::all(255)));
  }

  Pair first_, last_, last_square_;
  double low_, high_;
};

}  // namespace groundtruth::fast
