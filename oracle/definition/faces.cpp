#include <algorithm>
#include <stdexcept>

#include <groundtruth/definition/faces.hpp>
#include <groundtruth/definition/sample.hpp>

namespace groundtruth::definition {
namespace {

using Direction = Triple<Integer>;

bool parallel(const Direction& a, const Direction& b) {
  const Direction c = cross(a, b);
  return c[0].is_zero() && c[1].is_zero() && c[2].is_zero();
}

// A plane through the point, with all leaves that have it.
struct Plane {
  Direction normal;
  std::vector<Leaf> leaves;
};

std::vector<Plane> planes_through(const Expression& expression, const Sample& point) {
  std::vector<Plane> planes;
  for (Leaf leaf = 0; leaf < expression.half_spaces.size(); ++leaf) {
    if (!point.on_plane_of(leaf)) continue;
    const Direction& normal = expression.half_spaces[leaf].normal;
    const auto known = std::find_if(planes.begin(), planes.end(),
                                    [&](const Plane& plane) { return parallel(plane.normal, normal); });
    if (known == planes.end())
      planes.push_back({normal, {leaf}});
    else
      known->leaves.push_back(leaf);
  }
  return planes;
}

// The directions in which other planes cut this one, both ways along each cut.
std::vector<Direction> cuts(const Plane& plane, const std::vector<Plane>& planes) {
  std::vector<Direction> result;
  for (const Plane& other : planes) {
    if (&other == &plane) continue;
    const Direction cut = cross(plane.normal, other.normal);
    const auto known = [&](const Direction& direction) { return parallel(direction, cut); };
    if (std::none_of(result.begin(), result.end(), known)) result.insert(result.end(), {cut, -cut});
  }
  return result;
}

// By node: is it still there once constants are simplified away, if every leaf is replaced by its value at
// the sample but those whose plane passes through it? The expression is positive, so what is left of an
// operand is everything iff it holds with all those leaves false, and nothing iff it fails with all true.
std::vector<bool> standing(const Expression& expression, const Sample& sample) {
  const std::vector<Node>& nodes = expression.nodes;
  const std::vector<bool> everything = membership(expression, sample.sides, Reading::open);
  std::vector<bool> nothing = membership(expression, sample.sides, Reading::closed);
  nothing.flip();
  const auto swallows = [&](std::size_t operand) {
    const bool in_union = nodes[nodes[operand].parent].kind == Node::Kind::any_operand;
    return in_union ? everything[operand] : nothing[operand];
  };
  std::vector<std::size_t> swallowing_operands(nodes.size());
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (swallows(i)) ++swallowing_operands[nodes[i].parent];
  std::vector<bool> result(nodes.size(), true);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const std::size_t by_itself = swallows(i) ? 1 : 0;
    result[i] = result[nodes[i].parent] && swallowing_operands[nodes[i].parent] == by_itself;
  }
  return result;
}

// Collects what the samples around one point say.
class Survey {
 public:
  Survey(const Expression& expression, const Sample& centre)
      : expression_(expression), centre_(centre), bounds_(expression.half_spaces.size()) {
    const std::vector<Plane> planes = planes_through(expression, centre);
    // Every cell of space around the point has a wall in one of the planes, so all cells are seen.
    for (const Plane& plane : planes) visit(plane, cuts(plane, planes));
  }

  bool interior() const { return interior_; }
  bool bounds(Leaf leaf) const { return bounds_[leaf]; }

 private:
  // Of each sector into which the cuts divide the plane, a sample; then its two sides.
  void visit(const Plane& plane, const std::vector<Direction>& cuts) {
    if (cuts.empty()) visit_sector(plane, centre_);
    for (const Direction& cut : cuts) {
      const Sample on_cut = moved(expression_, centre_, cut);
      visit_sector(plane, moved(expression_, on_cut, cross(plane.normal, cut)));
    }
  }

  void visit_sector(const Plane& plane, const Sample& on_plane) {
    const bool in_front = member(moved(expression_, on_plane, plane.normal));
    const bool behind = member(moved(expression_, on_plane, -plane.normal));
    interior_ = interior_ && in_front && behind;
    if (!member(on_plane) || (in_front && behind)) return;
    const std::vector<bool> stands = standing(expression_, on_plane);
    for (const Leaf leaf : plane.leaves) {
      const bool same_way = dot(expression_.half_spaces[leaf].normal, plane.normal).sign() > 0;
      const bool outside_is_free = same_way ? !in_front : !behind;
      if (outside_is_free && stands[expression_.node_of_leaf[leaf]]) bounds_[leaf] = true;
    }
  }

  bool member(const Sample& sample) const {
    return membership(expression_, sample.sides, Reading::closed).front();
  }

  const Expression& expression_;
  const Sample& centre_;
  bool interior_ = true;
  std::vector<bool> bounds_;
};

}  // namespace

Faces faces_at(const Expression& expression, const Segment& segment, const Moment& moment) {
  const Sample centre = sample_at(expression, point_at(segment, moment));
  const Survey survey(expression, centre);
  if (survey.interior()) return {true, {}};

  const Triple<Whole> run = segment.last - segment.first;
  std::vector<Leaf> reachable;
  for (Leaf leaf = 0; leaf < expression.half_spaces.size(); ++leaf) {
    if (!centre.on_plane_of(leaf)) continue;
    const bool entered = dot(expression.half_spaces[leaf].normal, run).sign() < 0;
    if (moment.is_start() || entered) reachable.push_back(leaf);
  }
  Faces result;
  for (const Leaf leaf : reachable)
    if (survey.bounds(leaf)) result.admissible.push_back(leaf);
  if (result.admissible.empty()) {
    const std::vector<bool> stands = standing(expression, centre);
    for (const Leaf leaf : reachable)
      if (stands[expression.node_of_leaf[leaf]]) result.admissible.push_back(leaf);
  }
  if (result.admissible.empty()) throw std::logic_error("definition: a border without a face");
  return result;
}

std::optional<MaterialIndex> material_at(const Expression& expression, Leaf leaf, const Point& point) {
  std::optional<MaterialIndex> outermost;
  for (std::size_t i = expression.node_of_leaf[leaf]; i != 0;) {
    i = expression.nodes[i].parent;
    const Node& node = expression.nodes[i];
    if (!node.material) continue;
    if (!node.region || is_member(expression.regions[*node.region], point)) outermost = node.material;
  }
  return outermost;
}

}  // namespace groundtruth::definition
