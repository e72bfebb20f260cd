#pragma once
// A range against the squares of a grid, over lanes of any kind. Not installed.
//
// As cell_kernels_body.hpp: nothing here may be shared between sets of instructions, hence the templates.

#include <groundtruth/fast/grid.hpp>
#include <groundtruth/fast/lanes.hpp>

namespace groundtruth::fast {

// Both limits belong to it.
struct Squares {
  std::uint32_t first_column, last_column, first_row, last_row;

  [[gnu::always_inline]] inline std::size_t count() const {
    return std::size_t{last_column - first_column + 1} * (last_row - first_row + 1);
  }
};

// A longer range is better served by the hierarchy.
inline constexpr std::size_t most_squares = 6;

// The box around a range, grown by what rounding did to its ends: first across and along, last across and
// along abreast. The same operations as Grid's, hence the same places. Requires a grid with squares, and
// numbers that are all known (range_ends.hpp).
template <class Lanes>
class GridProbe {
 public:
  [[gnu::always_inline]] inline GridProbe(const Grid& grid, const double* first, const double* last,
                                          double coordinate_error) {
    const Lanes one = Lanes::four(first[grid.across], first[grid.along], first[grid.upward], 0);
    const Lanes other = Lanes::four(last[grid.across], last[grid.along], last[grid.upward], 0);
    const Lanes margin = Lanes::all(2 * coordinate_error);
    const Lanes low = lesser(one, other) - margin, high = greater(one, other) + margin;
    const Lanes origin =
        Lanes::four(grid.origin_across, grid.origin_along, grid.origin_across, grid.origin_along);
    places_ = (first_halves(low, high) - origin) * Lanes::all(grid.per_metre);
    const Lanes heights = (Lanes::four(low[2], high[2], 0, 0) - Lanes::all(grid.origin_upward)) *
                          Lanes::all(grid.upward_per_metre);
    std::int32_t whole[4];
    lesser(greater(heights, Lanes::all(0)), Lanes::all(Stretches::last_place)).store_whole(whole);
    first_upward_ = static_cast<std::uint32_t>(whole[0]);
    last_upward_ = static_cast<std::uint32_t>(whole[1]);
    const double last_column = grid.columns - 1, last_row = grid.rows - 1;
    last_square_ = Lanes::four(last_column, last_row, last_column, last_row);
  }

  [[gnu::always_inline]] inline Squares squares() const {
    std::int32_t whole[4];
    lesser(greater(places_, Lanes::all(0)), last_square_).store_whole(whole);
    const auto number = [&](int lane) { return static_cast<std::uint32_t>(whole[lane]); };
    return {number(0), number(2), number(1), number(3)};
  }

  // What of it concerns one square, to be compared with its entries.
  [[gnu::always_inline]] inline std::uint64_t in_square(std::uint32_t column, std::uint32_t row) const {
    const Lanes parts =
        (places_ - Lanes::four(column, row, column, row)) * Lanes::all(Stretches::last_place + 1);
    std::int32_t whole[4];
    lesser(greater(parts, Lanes::all(0)), Lanes::all(Stretches::last_place)).store_whole(whole);
    const auto part = [&](int lane) { return static_cast<std::uint32_t>(whole[lane]); };
    return Stretches{part(0), part(1), first_upward_, part(2), part(3), last_upward_}.of_range();
  }

 private:
  Lanes places_, last_square_;
  std::uint32_t first_upward_, last_upward_;
};

// Whether few enough squares are under it that a search should look at those.
[[gnu::always_inline]] inline bool is_served(const Squares& squares) {
  return squares.count() <= most_squares;
}

}  // namespace groundtruth::fast
