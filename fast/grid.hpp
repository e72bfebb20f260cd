#pragma once
// Squares over a flat scene: which parts are near a short range.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <groundtruth/fast/box.hpp>

namespace groundtruth::fast {

// Where something begins and ends, in 512ths of a square across and along it, in 512ths of the grid's height
// upward: six places of nine bits, below a bit each that is free.
struct Stretches {
  static constexpr std::uint32_t last_place = 511;

  std::uint32_t first_across, first_along, first_upward, last_across, last_along, last_upward;

  // In the order in which Stretches::reach() compares them.
  [[gnu::always_inline]] inline std::uint64_t of_part() const {
    return packed(first_across, first_along, first_upward, last_place - last_across, last_place - last_along,
                  last_place - last_upward);
  }
  [[gnu::always_inline]] inline std::uint64_t of_range() const {
    return packed(last_across, last_along, last_upward, last_place - first_across, last_place - first_along,
                  last_place - first_upward) |
           free_bits;
  }
  // 1 if a part begins nowhere behind where a range ends, and ends nowhere before it begins, else 0: six
  // comparisons at once, none of which borrows from the next.
  [[gnu::always_inline]] static inline unsigned reach(std::uint64_t range, std::uint64_t part) {
    return ((range - part) & free_bits) == free_bits;
  }

 private:
  static constexpr std::uint64_t free_bits = 0x0802008020080200;

  [[gnu::always_inline]] static inline std::uint64_t packed(std::uint64_t a, std::uint64_t b, std::uint64_t c,
                                                            std::uint64_t d, std::uint64_t e,
                                                            std::uint64_t f) {
    return a | b << 10 | c << 20 | d << 30 | e << 40 | f << 50;
  }
};

struct GridEntry {
  std::uint64_t places;  // of the part, in this square
  std::uint32_t part;
};

// Squares of one size over two axes. Entries of square (i, j) are starts[j * columns + i] to the next.
struct Grid {
  std::size_t across = 0;
  std::size_t along = 1;
  std::size_t upward = 2;  // the axis that is left
  double origin_across = 0;
  double origin_along = 0;
  double origin_upward = 0;
  double per_metre = 0;         // squares
  double upward_per_metre = 0;  // 512ths of the height
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;  // 0: there is no grid
  std::vector<std::uint32_t> starts;
  std::vector<GridEntry> entries;

  // Rounding is monotone: a coordinate no greater has a place no greater, in the grid, in a square and
  // upward. Outside is the nearest.
  std::uint32_t column_of(double x) const { return whole((x - origin_across) * per_metre, columns - 1); }
  std::uint32_t row_of(double x) const { return whole((x - origin_along) * per_metre, rows - 1); }

  std::uint32_t part_of_column(double x, std::uint32_t column) const {
    return part_of_square((x - origin_across) * per_metre, column);
  }
  std::uint32_t part_of_row(double x, std::uint32_t row) const {
    return part_of_square((x - origin_along) * per_metre, row);
  }
  std::uint32_t part_of_height(double x) const {
    return whole((x - origin_upward) * upward_per_metre, Stretches::last_place);
  }

 private:
  static std::uint32_t part_of_square(double place, std::uint32_t square) {
    return whole((place - square) * (Stretches::last_place + 1), Stretches::last_place);
  }
  static std::uint32_t whole(double place, std::uint32_t last) {
    if (!(place > 0)) return 0;
    return place < last ? static_cast<std::uint32_t>(place) : last;
  }
};

// Over boxes[part] of the parts named, which must be bounded. Without rows if squares would not help.
Grid build_grid(std::span<const Box> boxes, const std::vector<std::uint32_t>& parts);

}  // namespace groundtruth::fast
