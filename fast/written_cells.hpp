#pragma once
// Cells written alike. Not installed.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

// The cells seen so far, by numbers; a table of their hashes, so that few are compared.
class WrittenCells {
 public:
  explicit WrittenCells(std::size_t most_cells) : slots_(std::bit_ceil(2 * most_cells + 1)) {}

  // Whether an earlier cell is written like this one, which else is remembered. `half_spaces_of(number)`:
  // those of an earlier one.
  template <class HalfSpacesOf>
  bool has_or_add(std::span<const HalfSpace> cell, std::uint32_t number, HalfSpacesOf half_spaces_of) {
    const std::uint64_t hash = hash_of(cell);
    const std::size_t last = slots_.size() - 1;
    for (std::size_t place = hash & last;; place = (place + 1) & last) {
      Slot& slot = slots_[place];
      if (slot.number == no_number) {
        slot = {static_cast<std::uint32_t>(hash >> 32), number};
        return false;
      }
      if (slot.hash == hash >> 32 && std::ranges::equal(half_spaces_of(slot.number), cell)) return true;
    }
  }

 private:
  static constexpr std::uint32_t no_number = 0xffffffff;

  struct Slot {
    std::uint32_t hash = 0, number = no_number;
  };

  static std::uint64_t hash_of(std::span<const HalfSpace> cell) {
    std::uint64_t hash = cell.size();
    const auto mix = [&](double number) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15;  // -0 is 0
      hash ^= hash >> 32;
    };
    for (const auto& [normal, offset] : cell) {
      for (const double number : normal) mix(number);
      mix(offset);
    }
    return hash;
  }

  std::vector<Slot> slots_;
};

}  // namespace groundtruth::fast
