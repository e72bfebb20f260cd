#pragma once
// The entry point for a segment in either number type, for entry_point and step. Not installed.

#include <optional>

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/segment.hpp>

namespace groundtruth::fast {

template <class Number>
struct Entry {
  Number lambda;
  std::optional<Leaf> leaf;  // absent: the range starts in the interior
};

// Nothing: a miss. Requires range.first <= range.last. Number = double requires a scene of ordinary size.
template <class Number>
std::optional<Entry<Number>> find_entry(const Scene& scene, const Segment<Number>& segment,
                                        Range<Number> range);

}  // namespace groundtruth::fast
