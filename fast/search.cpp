#include <groundtruth/fast/search.hpp>

#include <algorithm>
#include <bit>

#include <groundtruth/fast/box_probe.hpp>
#include <groundtruth/fast/grid_probe.hpp>

namespace groundtruth::fast {

double SearchResult::lower() const {
  double least = 1;
  for (const Contender& contender : contenders) least = std::min(least, contender.meeting.lower);
  return least;
}

void SearchResult::drop_late_ones() {
  if (contenders.size() < 2) return;
  std::size_t kept = 0;
  for (const Contender& contender : contenders)
    if (contender.meeting.lower <= upper) contenders[kept++] = contender;
  contenders.resize(kept);
}

namespace {

class Search {
 public:
  Search(const Scene& scene, const Probe& probe, SearchResult& result)
      : scene_(scene), probe_(probe), result_(result) {}

  void visit(Part part) {
    const Meeting meeting = meet(part);
    if (meeting.lower > result_.upper) return;
    if (meeting.starts_inside()) {
      result_.starts_inside = true;
      return;
    }
    if (meeting.certainly_hits()) result_.upper = std::min(result_.upper, meeting.upper);
    result_.contenders.push_back({part, meeting});
  }

  bool is_over() const { return result_.starts_inside; }

  void visit_all_of_hierarchy() {
    for (const BoxNode& node : scene_.parts().hierarchy.nodes)
      for (const std::uint32_t child : node.children)
        if (child >= BoxNode::first_part && child != BoxNode::no_child && !is_over())
          visit(child - BoxNode::first_part);
  }

  // Nearest boxes first.
  void visit_hierarchy() {
    const BoxProbe box_probe(probe_.ends());
    const std::vector<BoxNode>& nodes = scene_.parts().hierarchy.nodes;
    boost::container::small_vector<Open, 128> open{{0, 0}};
    while (!open.empty()) {
      const Open top = open.back();
      open.pop_back();
      if (double{top.nearest} > result_.upper) continue;
      if (top.child >= BoxNode::first_part) {
        visit(top.child - BoxNode::first_part);
        if (is_over()) return;
        continue;
      }
      const BoxNode& node = nodes[top.child];
      float nearest[BoxNode::width];
      unsigned met = box_probe.meet(*scene_.parts().kernels, node, result_.upper, nearest);
      const std::size_t below = open.size();
      for (; met != 0; met &= met - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(met));
        open.push_back({nearest[i], node.children[i]});
        for (std::size_t at = open.size() - 1; at > below && open[at - 1].nearest < open[at].nearest; --at)
          std::swap(open[at - 1], open[at]);
      }
    }
  }

  // Only a range over few squares is looked up in them: false if it is longer, or there are none.
  bool visit_squares() {
    const Grid& grid = scene_.parts().grid;
    const GridProbe near(probe_.ends());
    const Squares squares = near.squares(grid);
    if (!is_served(grid, squares)) return false;
    for (std::uint32_t row = squares.first_row; row <= squares.last_row; ++row)
      for (std::uint32_t column = squares.first_column; column <= squares.last_column; ++column) {
        const std::size_t square = std::size_t{row} * grid.columns + column;
        const SquareProbe here = near.in_square(grid, column, row);
        for (std::uint32_t i = grid.starts[square]; i != grid.starts[square + 1]; ++i) {
          const GridEntry& entry = grid.entries[i];
          if (!here.reaches(entry) || (squares.count() > 1 && is_contender(entry.part))) continue;
          visit(entry.part);
          if (is_over()) return true;
        }
      }
    return true;
  }

 private:
  struct Open {
    float nearest;
    std::uint32_t child;
  };

  bool is_contender(Part part) const {
    return std::any_of(result_.contenders.begin(), result_.contenders.end(),
                       [&](const Contender& contender) { return contender.part == part; });
  }

  Meeting meet(Part part) {
    const Parts& parts = scene_.parts();
    if (parts.is_cell(part)) return fast::meet(*parts.kernels, parts.cells, parts.cells.cells[part], probe_);
    SievedExpression sieved;
    sieve(scene_.solid(), scene_.solid().nodes.data() + parts.node_of(part), probe_, sieved);
    return fast::meet(sieved);
  }

  const Scene& scene_;
  const Probe& probe_;
  SearchResult& result_;
};

}  // namespace

void search(const Scene& scene, const Probe& probe, SearchResult& result) {
  Search run(scene, probe, result);
  const Parts& parts = scene.parts();
  for (const Part part : parts.apart) {
    run.visit(part);
    if (run.is_over()) return;
  }
  if (!parts.hierarchy.nodes.empty()) {
    if (!(probe.ends().greatest_coordinate() < greatest_box_coordinate && probe.ends().coordinate_error < 1))
      run.visit_all_of_hierarchy();
    else if (!run.visit_squares())
      run.visit_hierarchy();
  }
  result.drop_late_ones();
}

Face sole_face(const Scene& scene, const Probe& probe, const SearchResult& result) {
  if (result.contenders.size() != 1) return {};
  const auto& [part, meeting] = result.contenders.front();
  if (!meeting.certainly_hits()) return {};
  const Parts& parts = scene.parts();
  if (parts.is_cell(part)) return sole_face(parts.cells, parts.cells.cells[part], meeting);
  SievedExpression sieved;
  sieve(scene.solid(), scene.solid().nodes.data() + parts.node_of(part), probe, sieved);
  const Leaf leaf = sole_leaf(sieved, meeting);
  return leaf == no_leaf ? Face{} : Face{leaf, scene.solid().leaves[leaf], {}};
}

}  // namespace groundtruth::fast
