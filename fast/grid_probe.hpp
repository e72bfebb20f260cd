#pragma once
// A range against the squares of a grid. Not installed.

#include <algorithm>

#include <groundtruth/fast/grid.hpp>
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

// The box around a range, grown by what rounding did to its ends.
class GridProbe {
 public:
  explicit GridProbe(const RangeEnds& ends) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(ends.first[axis], ends.last[axis]) - 2 * ends.coordinate_error;
      high_[axis] = std::max(ends.first[axis], ends.last[axis]) + 2 * ends.coordinate_error;
    }
  }

  Squares squares(const Grid& grid) const {
    return {grid.column_of(low_[grid.across]), grid.column_of(high_[grid.across]),
            grid.row_of(low_[grid.along]), grid.row_of(high_[grid.along])};
  }

  // The part of it that concerns one square.
  SquareProbe in_square(const Grid& grid, std::uint32_t column, std::uint32_t row) const {
    return {grid.part_of_column(low_[grid.across], column),
            grid.part_of_column(high_[grid.across], column),
            grid.part_of_row(low_[grid.along], row),
            grid.part_of_row(high_[grid.along], row),
            low_[grid.upward],
            high_[grid.upward]};
  }

 private:
  double low_[3];
  double high_[3];
};

}  // namespace groundtruth::fast
