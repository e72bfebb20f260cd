#include <groundtruth/tests/bench/memory.hpp>

#include <sys/resource.h>

namespace groundtruth::bench {

namespace {

template <class Element>
std::size_t bytes_of(const std::vector<Element>& vector) {
  return vector.capacity() * sizeof(Element);
}

std::size_t bytes_of(const fast::Expression& expression) {
  return bytes_of(expression.nodes) + bytes_of(expression.leaves);
}

}  // namespace

std::size_t bytes_of(const fast::Scene& scene) {
  const fast::Parts& parts = scene.parts();
  std::size_t bytes = bytes_of(scene.solid()) + bytes_of(scene.rules()) + bytes_of(scene.rule_runs()) +
                      bytes_of(scene.region_boxes()) + bytes_of(parts.cells.groups) +
                      bytes_of(parts.cells.leaves) + bytes_of(parts.cells.cells) + bytes_of(parts.general) +
                      bytes_of(parts.apart) + bytes_of(parts.hierarchy.nodes) + bytes_of(parts.grid.starts) +
                      bytes_of(parts.grid.entries) + bytes_of(scene.regions());
  for (const fast::Expression& region : scene.regions()) bytes += bytes_of(region);
  return bytes;
}

std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace groundtruth::bench
