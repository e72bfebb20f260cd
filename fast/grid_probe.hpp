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

  bool reaches(const GridEntry& entry) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (double{entry.low[axis]} > high_[axis] || double{entry.high[axis]} < low_[axis]) return false;
    return true;
  }

 private:
  double low_[3];
  double high_[3];
};

}  // namespace groundtruth::fast
