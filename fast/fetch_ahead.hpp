#pragma once
// Memory that asks will look at, asked to come closer before they do. Not installed.

#include <cstddef>
#include <cstdint>
#include <span>

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// Of asks that are answered in this order. From an ask to the half-spaces of the first part over its square
// there is a chain of links, each found in the one before it; different asks wait for different links at the
// same time. Where there are no squares only asks and answers are fetched.
class FetchAhead {
 public:
  FetchAhead(const Scene& scene, std::span<const EntryAsk> asks, std::span<const EntryAnswer> answers,
             std::span<const std::uint32_t> order)
      : parts_(scene.parts()), asks_(asks), answers_(answers), order_(order) {}

  // Before the i-th is answered.
  void advance(std::size_t i) {
    if (i + 5 * step < order_.size()) fetch_ask(i + 5 * step);
    if (parts_.grid.rows == 0) return;
    if (i + 4 * step < order_.size()) fetch_square(i + 4 * step);
    if (i + 3 * step < order_.size()) fetch_entry(i + 3 * step);
    if (i + 2 * step < order_.size()) fetch_cell(i + 2 * step);
    if (i + step < order_.size()) fetch_half_spaces(i + step);
  }

 private:
  static constexpr std::size_t step = 4, in_flight = 16;  // those between fetch_square and fetch_half_spaces

  struct InFlight {
    std::uint32_t square;
    Part part;
  };

  static void fetch(const void* first, std::size_t size) {
    const char* const bytes = static_cast<const char*>(first);
    for (std::size_t at = 0; at < size; at += 64) __builtin_prefetch(bytes + at);
    __builtin_prefetch(bytes + size - 1);
  }

  void fetch_ask(std::size_t i) const {
    fetch(&asks_[order_[i]], sizeof(EntryAsk));
    fetch(&answers_[order_[i]], sizeof(EntryAnswer));
  }
  void fetch_square(std::size_t i) {
    const Grid& grid = parts_.grid;
    const Vector& from = asks_[order_[i]].from;
    const std::uint32_t square =
        grid.row_of(from[grid.along]) * grid.columns + grid.column_of(from[grid.across]);
    in_flight_[i % in_flight].square = square;
    __builtin_prefetch(&grid.starts[square]);
  }
  void fetch_entry(std::size_t i) const {
    const std::uint32_t first = parts_.grid.starts[in_flight_[i % in_flight].square];
    if (first != parts_.grid.entries.size()) __builtin_prefetch(&parts_.grid.entries[first]);
  }
  void fetch_cell(std::size_t i) {
    InFlight& ask = in_flight_[i % in_flight];
    const std::uint32_t first = parts_.grid.starts[ask.square];
    ask.part = first != parts_.grid.starts[ask.square + 1] ? parts_.grid.entries[first].part : no_part;
    if (parts_.is_cell(ask.part)) __builtin_prefetch(&parts_.cells.cells[ask.part]);
  }
  void fetch_half_spaces(std::size_t i) const {
    const Part part = in_flight_[i % in_flight].part;
    if (!parts_.is_cell(part)) return;
    const Cell& cell = parts_.cells.cells[part];
    constexpr std::size_t most_groups = 2;  // what a house has
    fetch(parts_.cells.groups.data() + cell.first_group, most_groups * sizeof(HalfSpaces4));
  }

  static constexpr Part no_part = 0xffffffff;

  const Parts& parts_;
  const std::span<const EntryAsk> asks_;
  const std::span<const EntryAnswer> answers_;
  const std::span<const std::uint32_t> order_;
  InFlight in_flight_[in_flight]{};
};

}  // namespace groundtruth::fast
