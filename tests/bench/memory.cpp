#include <groundtruth/tests/bench/memory.hpp>

#include <sys/resource.h>

namespace groundtruth::bench {

namespace {

template <class Element>
std::size_t bytes_held_by(const std::vector<Element>& vector) {
  return vector.capacity() * sizeof(Element);
}

template <class Element>
std::size_t bytes_held_by(const fast::LargeVector<Element>& vector) {
  const std::size_t bytes = vector.capacity() * sizeof(Element), page = fast::large_page;
  return bytes < 2 * page ? bytes : (bytes + page - 1) / page * page;
}

std::size_t bytes_of(const fast::Expression& expression) {
  return bytes_held_by(expression.nodes) + bytes_held_by(expression.leaves);
}

}  // namespace

std::size_t bytes_of(const fast::Scene& scene) {
  const fast::Parts& parts = scene.parts();
  std::size_t bytes =
      bytes_of(scene.solid()) + bytes_held_by(scene.rules()) + bytes_held_by(scene.rule_runs()) +
      bytes_held_by(scene.region_boxes()) + bytes_held_by(parts.cells.groups) +
      bytes_held_by(parts.cells.leaves) + bytes_held_by(parts.cells.cells) + bytes_held_by(parts.general) +
      bytes_held_by(parts.apart) + bytes_held_by(parts.hierarchy.nodes) + bytes_held_by(parts.grid.starts) +
      bytes_held_by(parts.grid.entries) + bytes_held_by(scene.regions());
  for (const fast::Expression& region : scene.regions()) bytes += bytes_of(region);
  return bytes;
}

std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace groundtruth::bench
