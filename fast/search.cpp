#include <groundtruth/fast/search.hpp>

#include <algorithm>
#include <utility>

#include <groundtruth/fast/box_probe.hpp>
#include <groundtruth/fast/cell_kernels.hpp>

namespace groundtruth::fast {

void SearchResult::drop_late_ones() {
  std::size_t kept = 0;
  for (const Contender& contender : contenders)
    if (contender.meeting.lower <= upper) contenders[kept++] = contender;
  contenders.shrink(kept);
}

void Contenders::grow() {
  auto more = std::make_unique<Contender[]>(2 * capacity_);
  std::copy(begin(), end(), more.get());
  more_ = std::move(more);
  first_ = more_.get();
  capacity_ *= 2;
}

Meeting meet_general(const SearchTask& task, Part part) {
  const auto& scene = *static_cast<const Scene*>(task.context);
  SievedExpression sieved;
  sieve(scene.solid(), scene.solid().nodes.data() + scene.parts().node_of(part), task.probe, sieved);
  return meet(sieved);
}

void search_hierarchy(const Parts& parts, SearchTask& task) {
  const RangeEnds& ends = task.probe.ends();
  if (suit_boxes(task.probe.greatest_coordinate(), ends.coordinate_error)) {
    parts.kernels->visit_hierarchy(task, parts.hierarchy.nodes.data(), BoxProbe(ends).way());
    return;
  }
  for (const BoxNode& node : parts.hierarchy.nodes)
    for (const std::uint32_t child : node.children) {
      if (child < BoxNode::first_part || child == BoxNode::no_child) continue;
      const Part part = child - BoxNode::first_part;
      parts.kernels->visit_parts(task, &part, &part + 1);
      if (task.result.starts_inside) return;
    }
}

Face sole_face_of_general(const Scene& scene, const Probe& probe, const Contender& contender) {
  SievedExpression sieved;
  sieve(scene.solid(), scene.solid().nodes.data() + scene.parts().node_of(contender.part), probe, sieved);
  const Leaf leaf = sole_leaf(sieved, contender.meeting);
  return leaf == no_leaf ? Face{} : Face{leaf, scene.solid().leaves[leaf], {}};
}

}  // namespace groundtruth::fast
