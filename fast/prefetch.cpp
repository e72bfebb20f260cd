#include <groundtruth/fast/prefetch.hpp>

namespace groundtruth::fast {

namespace {

void fetch(const void* address) { __builtin_prefetch(address); }

// Two groups of half-spaces are what a house has.
constexpr std::size_t most_bytes_of_cell = 2 * sizeof(HalfSpaces4);
constexpr std::size_t fewest_entries = 10000;

}  // namespace

Prefetcher::Prefetcher(const Scene& scene)
    : parts_(scene.parts()), is_large_(parts_.grid.entries.size() >= fewest_entries) {
  recent_.fill(no_square);
}

void Prefetcher::fetch(std::span<const EntryAsk> asks) {
  if (!is_large_) return;
  ask_count_ = part_count_ = 0;
  for (const EntryAsk& ask : asks) add(ask);
  if (ask_count_ == 0) return;
  fetch_entries();
  fetch_cells();
  fetch_half_spaces();
}

void Prefetcher::add(const EntryAsk& ask) {
  const Grid& grid = parts_.grid;
  const RangeEnds ends = ends_of(ask);
  const GridProbe<Lanes> near(grid, ends.first.data(), ends.last.data(), ends.coordinate_error);
  const Squares squares = near.squares();
  const std::uint32_t square = squares.first_row * grid.columns + squares.first_column;
  if (recent_[square % recent_squares] == square || !is_served(squares)) return;
  recent_[square % recent_squares] = square;
  asks_[ask_count_++] = {square, 0, 0, near.in_square(squares.first_column, squares.first_row)};
  fast::fetch(&grid.starts[square]);
}

void Prefetcher::fetch_entries() {
  const Grid& grid = parts_.grid;
  for (std::size_t i = 0; i != ask_count_; ++i) {
    InFlight& ask = asks_[i];
    ask.first_entry = grid.starts[ask.square];
    ask.end_entry = grid.starts[ask.square + 1];
    if (ask.first_entry == ask.end_entry) continue;
    fast::fetch(&grid.entries[ask.first_entry]);
    fast::fetch(&grid.entries[ask.end_entry - 1]);
  }
}

void Prefetcher::fetch_cells() {
  for (std::size_t i = 0; i != ask_count_; ++i) {
    const InFlight& ask = asks_[i];
    std::size_t room = most_parts;
    for (std::uint32_t at = ask.first_entry; at != ask.end_entry && room != 0; ++at) {
      const GridEntry& entry = parts_.grid.entries[at];
      if (!parts_.is_cell(entry.part) || Stretches::reach(ask.here, entry.places) == 0) continue;
      cells_[part_count_++] = entry.part;
      fast::fetch(&parts_.cells.cells[entry.part]);
      --room;
    }
  }
}

void Prefetcher::fetch_half_spaces() const {
  const PackedCells& cells = parts_.cells;
  for (std::size_t i = 0; i != part_count_; ++i) {
    const Cell& cell = cells.cells[cells_[i]];
    if (cell.leaf_count == 0) continue;
    const char* const bytes = reinterpret_cast<const char*>(&cells.groups[cell.first_group]);
    for (std::size_t at = 0; at < most_bytes_of_cell; at += 64) fast::fetch(bytes + at);
  }
}

}  // namespace groundtruth::fast
