#include <groundtruth/fast/paint.hpp>

#include <algorithm>
#include <cmath>

#include <groundtruth/fast/exact_stage/entry.hpp>

namespace groundtruth::fast {

namespace {

enum class Membership { no, open, yes };

// Whole planes that are written alike, or opposite: then neither needs a look at numbers.
bool have_one_plane_as_written(const HalfSpace& a, const HalfSpace& b) {
  if (a == b) return true;
  const auto& n = b.normal;
  return a.offset == -b.offset && a.normal == Vector{-n[0], -n[1], -n[2]};
}

// Is the hit in a region?
class RegionView {
 public:
  RegionView(const Expression& region, const Probe& probe, const HitPlace& place, const HalfSpace& face)
      : region_(region), probe_(probe), place_(place), face_(face) {}

  Membership of_whole() const { return of(region_.nodes.data()); }

 private:
  Membership of(const Node* node) const {
    switch (node->kind) {
      case NodeKind::nothing:
        return Membership::no;
      case NodeKind::everything:
        return Membership::yes;
      case NodeKind::cell:
        return of_cell(*node);
      case NodeKind::union_of:
      case NodeKind::intersection_of:
        break;
    }
    const Membership absorbing = node->kind == NodeKind::union_of ? Membership::yes : Membership::no;
    Membership all = absorbing == Membership::yes ? Membership::no : Membership::yes;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const Membership one = of(operand);
      if (one == absorbing) return one;
      if (one == Membership::open) all = one;
    }
    return all;
  }

  Membership of_cell(const Node& cell) const {
    Membership all = Membership::yes;
    for (std::uint32_t leaf = cell.first_leaf; leaf != cell.end_leaf; ++leaf) {
      const Membership one = of_leaf(region_.leaves[leaf]);
      if (one == Membership::no) return one;
      if (one == Membership::open) all = one;
    }
    return all;
  }

  // Delta is linear: what holds at both ends of [lower, upper] holds between them. Lemma clip-interval.
  Membership of_leaf(const HalfSpace& leaf) const {
    if (have_one_plane_as_written(leaf, face_)) return Membership::yes;
    const auto& [n, d] = leaf;
    const double error =
        probe_.error_bound((std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2])) * (1 + 0x1p-50), std::abs(d));
    if (!(error < greatest_usable_error)) return Membership::open;
    const Vector &x = probe_.ends().first, &y = probe_.ends().last;
    const double a = n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - d;
    const double b = n[0] * y[0] + n[1] * y[1] + n[2] * y[2] - d;
    const double at_lower = a + place_.lower * (b - a), at_upper = a + place_.upper * (b - a);
    if (at_lower < -error && at_upper < -error) return Membership::yes;
    if (at_lower > error && at_upper > error) return Membership::no;
    return Membership::open;
  }

  const Expression& region_;
  const Probe& probe_;
  const HitPlace& place_;
  const HalfSpace& face_;
};

// The box in which the hit certainly lies. Lemma hit-outside-box (proofs-notes/rounding.md): a coordinate is
// off by at most 4 u (|x| + |y|) and the ends' own error.
Box box_around_hit(const Probe& probe, const HitPlace& place) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = probe.ends().first[axis], y = probe.ends().last[axis];
    const double error =
        0x8p-53 * (std::abs(x) + std::abs(y)) + 0x1.01p0 * probe.ends().coordinate_error + 0x1p-1000;
    const double at_lower = x + place.lower * (y - x), at_upper = x + place.upper * (y - x);
    box.low[axis] = std::min(at_lower, at_upper) - error;
    box.high[axis] = std::max(at_lower, at_upper) + error;
  }
  return box;
}

// Without branches: which side a hit is of is hard to foretell.
bool are_apart(const Box& a, const Box& b) {
  bool apart = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    apart |= a.high[axis] < b.low[axis];
    apart |= a.low[axis] > b.high[axis];
  }
  return apart;
}

// Is the hit in this region or that?
class HitView {
 public:
  HitView(const Scene& scene, const Probe& probe, const HitPlace& place)
      : scene_(scene), probe_(probe), place_(place), around_(box_around_hit(probe, place)) {}

  Membership of(std::uint32_t region) const {
    if (are_apart(around_, scene_.region_boxes()[region])) return Membership::no;
    return RegionView(scene_.regions()[region], probe_, place_, place_.face.half_space).of_whole();
  }

 private:
  const Scene& scene_;
  const Probe& probe_;
  const HitPlace& place_;
  const Box around_;
};

std::optional<HalfSpace> crossed_at(const HitPlace& place) {
  return place.crossed == nullptr ? std::nullopt : std::optional(*place.crossed);
}

std::optional<std::uint32_t> innermost_rule(const Scene& scene, const Face& face) {
  const std::uint32_t rule = face.material.rule;
  return rule != CellMaterial::unknown_rule ? rule : scene.rule_of(static_cast<std::uint32_t>(face.leaf));
}

}  // namespace

FaceMaterial material_at(const Scene& scene, const Probe& probe, const EntryAsk& ask, const HitPlace& place) {
  // Rules are linked from the innermost outwards, and the outermost that holds decides.
  FaceMaterial found;
  const HitView hit(scene, probe, place);
  for (auto at = innermost_rule(scene, place.face); at; at = scene.rules()[*at].outer_rule) {
    const MaterialRule& rule = scene.rules()[*at];
    if (rule.region) {
      const Expression& region = scene.regions()[*rule.region];
      Membership member = hit.of(*rule.region);
      if (member == Membership::open) {
        found.stage = Stage::exact;
        const exact_stage::ExpressionView view{region.nodes, region.leaves, {}};
        member = exact_stage::contains(view, ask, crossed_at(place)) ? Membership::yes : Membership::no;
      }
      if (member == Membership::no) continue;
    }
    found.material = rule.material;
  }
  return found;
}

std::optional<std::optional<MaterialIndex>> material_by_doubles(const Scene& scene, const Probe& probe,
                                                                const HitPlace& place) {
  std::optional<MaterialIndex> material;
  const HitView hit(scene, probe, place);
  for (auto at = innermost_rule(scene, place.face); at; at = scene.rules()[*at].outer_rule) {
    const MaterialRule& rule = scene.rules()[*at];
    const Membership member = rule.region ? hit.of(*rule.region) : Membership::yes;
    if (member == Membership::open) return std::nullopt;
    if (member == Membership::yes) material = rule.material;
  }
  return material;
}

}  // namespace groundtruth::fast
