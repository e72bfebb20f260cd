#pragma once
// Squares over a flat scene: which parts are near a short range.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <groundtruth/fast/box.hpp>

namespace groundtruth::fast {

// A part over a square, with its box in floats, rounded outwards.
struct GridEntry {
  float low[3];
  float high[3];
  std::uint32_t part;
};

// Squares of one size over two axes. Entries of square (i, j) are starts[j * columns + i] to the next.
struct Grid {
  std::size_t across = 0;
  std::size_t along = 1;
  double origin_across = 0;
  double origin_along = 0;
  double per_metre = 0;  // squares
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;  // 0: there is no grid
  std::vector<std::uint32_t> starts;
  std::vector<GridEntry> entries;

  // Rounding is monotone: a coordinate no greater has a place no greater. Outside is the nearest square.
  std::uint32_t column_of(double x) const { return place(x, origin_across, columns); }
  std::uint32_t row_of(double x) const { return place(x, origin_along, rows); }

 private:
  std::uint32_t place(double x, double origin, std::uint32_t count) const {
    const double place = (x - origin) * per_metre;
    if (!(place > 0)) return 0;
    return place < count ? static_cast<std::uint32_t>(place) : count - 1;
  }
};

// Over boxes[part] of the parts named, which must be bounded. Without rows if squares would not help.
Grid build_grid(const std::vector<Box>& boxes, const std::vector<std::uint32_t>& parts);

}  // namespace groundtruth::fast
