#include <groundtruth/fast/grid_probe.hpp>
#include <groundtruth/fast/search.hpp>

namespace groundtruth::fast {

namespace {

void fetch(const void* address) { __builtin_prefetch(address); }

// Two groups of half-spaces are what a house has.
constexpr std::size_t most_bytes_of_cell = 2 * sizeof(HalfSpaces4);

}  // namespace

Prefetcher::Prefetcher(const Scene& scene, const RangeEnds& ends) : scene_(scene) {
  const Grid& grid = scene.parts().grid;
  if (grid.rows == 0) return;
  const GridProbe<Lanes> near(grid, ends.first.data(), ends.last.data(), ends.coordinate_error);
  const Squares squares = near.squares();
  if (!is_served(squares)) return;
  has_square_ = true;
  here_ = near.in_square(squares.first_column, squares.first_row);
  square_ = std::size_t{squares.first_row} * grid.columns + squares.first_column;
}

void Prefetcher::fetch_starts() const {
  if (has_square_) fetch(&scene_.parts().grid.starts[square_]);
}

void Prefetcher::fetch_entries() const {
  if (!has_square_) return;
  const Grid& grid = scene_.parts().grid;
  const std::uint32_t first = grid.starts[square_], end = grid.starts[square_ + 1];
  if (first == end) return;
  fetch(&grid.entries[first]);
  fetch(&grid.entries[end - 1]);
}

void Prefetcher::fetch_cells() {
  if (!has_square_) return;
  const Grid& grid = scene_.parts().grid;
  for (std::uint32_t i = grid.starts[square_]; i != grid.starts[square_ + 1] && part_count_ < most_parts;
       ++i) {
    const GridEntry& entry = grid.entries[i];
    if (!scene_.parts().is_cell(entry.part) || Stretches::reach(here_, entry.places) == 0) continue;
    parts_[part_count_++] = entry.part;
    fetch(&scene_.parts().cells.cells[entry.part]);
  }
}

void Prefetcher::fetch_half_spaces() const {
  const PackedCells& cells = scene_.parts().cells;
  for (std::size_t i = 0; i < part_count_; ++i) {
    const Cell& cell = cells.cells[parts_[i]];
    if (cell.leaf_count == 0) continue;
    const char* const bytes = reinterpret_cast<const char*>(&cells.groups[cell.first_group]);
    for (std::size_t at = 0; at < most_bytes_of_cell; at += 64) fetch(bytes + at);
  }
}

}  // namespace groundtruth::fast
