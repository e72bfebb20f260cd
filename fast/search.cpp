#include <groundtruth/fast/search.hpp>

#include <algorithm>

namespace groundtruth::fast {

double SearchResult::lower() const {
  double least = 1;
  for (const Contender& contender : contenders) least = std::min(least, contender.meeting.lower);
  return least;
}

void SearchResult::drop_late_ones() {
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

 private:
  Meeting meet(Part part) {
    const Parts& parts = scene_.parts();
    if (parts.is_cell(part)) return fast::meet(parts.cells, parts.cells.cells[part], probe_);
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
  const auto parts = static_cast<Part>(scene.parts().size());
  for (Part part = 0; part != parts && !run.is_over(); ++part) run.visit(part);
  result.drop_late_ones();
}

Leaf sole_leaf(const Scene& scene, const Probe& probe, const SearchResult& result) {
  if (result.contenders.size() != 1) return no_leaf;
  const auto& [part, meeting] = result.contenders.front();
  if (!meeting.certainly_hits()) return no_leaf;
  const Parts& parts = scene.parts();
  if (parts.is_cell(part)) return sole_leaf(parts.cells, parts.cells.cells[part], probe, meeting);
  SievedExpression sieved;
  sieve(scene.solid(), scene.solid().nodes.data() + parts.node_of(part), probe, sieved);
  return sole_leaf(sieved, meeting);
}

}  // namespace groundtruth::fast
