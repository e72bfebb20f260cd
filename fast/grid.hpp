#pragma once
// Squares over a flat scene: which parts are near a short range.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <groundtruth/fast/box.hpp>

namespace groundtruth::fast {

// A part over a square: where it lies in the square, in 256ths of its side, and its height over the other
// axis, in floats rounded outwards.
struct GridEntry {
  std::uint8_t first_across, last_across, first_along, last_along;
  float low;
  float high;
  std::uint32_t part;
};

// Squares of one size over two axes. Entries of square (i, j) are starts[j * columns + i] to the next.
struct Grid {
  std::size_t across = 0;
  std::size_t along = 1;
  std::size_t upward = 2;  // the axis that is left
  double origin_across = 0;
  double origin_along = 0;
  double per_metre = 0;  // squares
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;  // 0: there is no grid
  std::vector<std::uint32_t> starts;
  std::vector<GridEntry> entries;

  // Rounding is monotone: a coordinate no greater has a place no greater, in the grid and in a square.
  // Outside is the nearest.
  std::uint32_t column_of(double x) const { return place(x, origin_across, columns); }
  std::uint32_t row_of(double x) const { return place(x, origin_along, rows); }

  std::uint8_t part_of_column(double x, std::uint32_t column) const {
    return part_of_square(x, origin_across, column);
  }
  std::uint8_t part_of_row(double x, std::uint32_t row) const { return part_of_square(x, origin_along, row); }

 private:
  std::uint8_t part_of_square(double x, double origin, std::uint32_t square) const {
    const double part = ((x - origin) * per_metre - square) * 256;
    if (!(part > 0)) return 0;
    return part < 255 ? static_cast<std::uint8_t>(part) : 255;
  }
  std::uint32_t place(double x, double origin, std::uint32_t count) const {
    const double place = (x - origin) * per_metre;
    if (!(place > 0)) return 0;
    return place < count ? static_cast<std::uint32_t>(place) : count - 1;
  }
};

// Over boxes[part] of the parts named, which must be bounded. Without rows if squares would not help.
Grid build_grid(const std::vector<Box>& boxes, const std::vector<std::uint32_t>& parts);

}  // namespace groundtruth::fast
