#pragma once
// What a search reads and writes, as kernels see it. Not installed.
//
// Plain numbers and pointers: a kernel calls nothing of the standard library's (cell_kernels_body.hpp).

#include <cstddef>
#include <cstdint>

#include <groundtruth/fast/contenders.hpp>
#include <groundtruth/fast/parts.hpp>

namespace groundtruth::fast {

class Probe;

// Guarantees: if the range meets the solid, every part that contains its first point there is a contender,
// and that point lies at lower() <= s <= upper. Nothing left: a certain miss.
struct SearchResult {
  Contenders contenders;
  double upper = 1;
  bool starts_inside = false;  // certainly; contenders mean nothing then

  double lower() const {
    double least = 1;
    for (const Contender& contender : contenders)
      if (contender.meeting.lower < least) least = contender.meeting.lower;
    return least;
  }
  // Drops the contenders that start behind `upper`.
  void drop_late_ones();
};

struct SearchTask {
  const HalfSpaces4* groups;
  const Cell* cells;
  std::size_t cell_count;  // parts from here on are general ones
  const Part* apart;
  const Part* apart_end;
  const Grid& grid;
  const std::uint32_t* starts;  // of the grid's squares
  const GridEntry* entries;
  const double* first;  // the range's ends
  const double* last;
  const Probe& probe;  // of that range
  SearchResult& result;
  Meeting (*meet_general)(const SearchTask& task, Part part);
  const void* context;  // of meet_general
};

}  // namespace groundtruth::fast
