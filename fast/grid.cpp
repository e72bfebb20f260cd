#include <groundtruth/fast/grid.hpp>

#include <algorithm>
#include <cmath>

namespace groundtruth::fast {

namespace {

constexpr std::size_t fewest_parts = 16;
constexpr double most_entries_per_part = 12;

struct Squares {
  std::uint32_t first_column, last_column, first_row, last_row;
  std::size_t count() const {
    return std::size_t{last_column - first_column + 1} * (last_row - first_row + 1);
  }
};

Squares squares_of(const Grid& grid, const Box& box) {
  return {grid.column_of(box.low[grid.across]), grid.column_of(box.high[grid.across]),
          grid.row_of(box.low[grid.along]), grid.row_of(box.high[grid.along])};
}

GridEntry entry_of(const Grid& grid, const Box& box, std::uint32_t column, std::uint32_t row,
                   std::uint32_t part) {
  const Stretches stretches{
      grid.part_of_column(box.low[grid.across], column), grid.part_of_row(box.low[grid.along], row),
      grid.part_of_height(box.low[grid.upward]),         grid.part_of_column(box.high[grid.across], column),
      grid.part_of_row(box.high[grid.along], row),       grid.part_of_height(box.high[grid.upward])};
  return {stretches.of_part(), part};
}

// About as many squares as parts, over the two axes along which the scene is widest.
Grid lay_out(const Box& scene, std::size_t parts) {
  Grid grid;
  const auto width = [&](std::size_t axis) { return scene.high[axis] - scene.low[axis]; };
  std::size_t thinnest = 2;
  for (const std::size_t axis : {std::size_t{1}, std::size_t{0}})
    if (width(axis) < width(thinnest)) thinnest = axis;
  grid.across = thinnest == 0 ? 1 : 0;
  grid.along = thinnest == 2 ? 1 : 2;
  grid.upward = thinnest;
  const double area = width(grid.across) * width(grid.along);
  const double square = std::max(std::sqrt(area / static_cast<double>(parts)),
                                 std::max(width(grid.across), width(grid.along)) / 0x1p16);
  if (!(square > 0) || !std::isfinite(square)) return grid;
  // Off the round numbers on which parts begin and end: there a part would be in two squares more.
  grid.origin_across = scene.low[grid.across] - 0.37 * square;
  grid.origin_along = scene.low[grid.along] - 0.37 * square;
  grid.per_metre = 1 / square;
  grid.origin_upward = scene.low[grid.upward];
  // A flat scene has one height.
  if (width(grid.upward) > 0) grid.upward_per_metre = (Stretches::last_place + 1) / width(grid.upward);
  grid.columns = static_cast<std::uint32_t>((width(grid.across) * grid.per_metre) + 2);
  grid.rows = static_cast<std::uint32_t>((width(grid.along) * grid.per_metre) + 2);
  return grid;
}

}  // namespace

Grid build_grid(std::span<const Box> boxes, const std::vector<std::uint32_t>& parts) {
  if (parts.size() < fewest_parts) return {};
  Box scene = nowhere;
  for (const std::uint32_t part : parts) scene = hull(scene, boxes[part]);
  Grid grid = lay_out(scene, parts.size());
  if (grid.rows == 0) return {};

  std::size_t entries = 0;
  for (const std::uint32_t part : parts) entries += squares_of(grid, boxes[part]).count();
  if (static_cast<double>(entries) > most_entries_per_part * static_cast<double>(parts.size())) return {};

  const auto visit = [&](auto&& each) {
    for (const std::uint32_t part : parts) {
      const Squares squares = squares_of(grid, boxes[part]);
      for (std::uint32_t row = squares.first_row; row <= squares.last_row; ++row)
        for (std::uint32_t column = squares.first_column; column <= squares.last_column; ++column)
          each(column, row, part);
    }
  };
  grid.starts.assign(std::size_t{grid.columns} * grid.rows + 1, 0);
  const auto square_of = [&](std::uint32_t column, std::uint32_t row) {
    return std::size_t{row} * grid.columns + column;
  };
  visit([&](std::uint32_t column, std::uint32_t row, std::uint32_t) {
    ++grid.starts[square_of(column, row) + 1];
  });
  for (std::size_t square = 1; square < grid.starts.size(); ++square)
    grid.starts[square] += grid.starts[square - 1];
  grid.entries.resize(entries);
  std::vector<std::uint32_t> next(grid.starts.begin(), grid.starts.end() - 1);
  visit([&](std::uint32_t column, std::uint32_t row, std::uint32_t part) {
    grid.entries[next[square_of(column, row)]++] = entry_of(grid, boxes[part], column, row, part);
  });
  return grid;
}

}  // namespace groundtruth::fast
