#include <groundtruth/fast/face.hpp>
#include <groundtruth/fast/sector.hpp>

namespace groundtruth::fast {

namespace {

// What a local shape is for the directions v of a sector of a leaf's plane.
struct View {
  bool at = false;                 // v itself belongs to it
  bool outward = false;            // v, turned a little outward from the leaf
  Value simplified = Value::open;  // with all leaves of other planes replaced by their values at v
  bool leaf_stands = false;        // the leaf is still there then
};

class SectorView {
 public:
  SectorView(const LocalShape& shape, const Expression& solid, Leaf leaf, const Sector& sector)
      : shape_(shape), solid_(solid), leaf_(leaf), sector_(sector) {}

  View of_shape() const { return of(shape_.nodes.data()); }

 private:
  View of(const LocalNode* node) const {
    if (node->kind == NodeKind::cell) return of_leaf(node->leaf);
    return node->kind == NodeKind::union_of ? of_union(node) : of_intersection(node);
  }

  View of_leaf(Leaf leaf) const {
    const HalfSpace& half_space = solid_.leaves[leaf];
    const Truth truth = sector_.contains(half_space);
    if (truth == Truth::yes) return {true, true, Value::everything, false};
    if (truth == Truth::no) return {false, false, Value::nothing, false};
    const bool alike = sector_.faces_alike(half_space);
    return {true, !alike, Value::open, leaf == leaf_};
  }

  View of_union(const LocalNode* node) const {
    View all{false, false, Value::nothing, false};
    for (const LocalNode* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const View one = of(operand);
      if (one.simplified == Value::everything) return one;
      all.at |= one.at;
      all.outward |= one.outward;
      all.leaf_stands |= one.leaf_stands;
      if (one.simplified == Value::open) all.simplified = Value::open;
    }
    return all;
  }

  View of_intersection(const LocalNode* node) const {
    View all{true, true, Value::everything, false};
    for (const LocalNode* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const View one = of(operand);
      if (one.simplified == Value::nothing) return one;
      all.at &= one.at;
      all.outward &= one.outward;
      all.leaf_stands |= one.leaf_stands;
      if (one.simplified == Value::open) all.simplified = Value::open;
    }
    return all;
  }

  const LocalShape& shape_;
  const Expression& solid_;
  const Leaf leaf_;
  const Sector& sector_;
};

// Is there a sector of the leaf's plane whose view satisfies the predicate?
template <class Predicate>
bool some_sector(const LocalShape& shape, const Expression& solid, Leaf leaf, Predicate predicate) {
  const HalfSpace& face = solid.leaves[leaf];
  bool is_cut = false;
  for (const LocalNode& node : shape.nodes) {
    if (node.kind != NodeKind::cell || have_one_plane(face, solid.leaves[node.leaf])) continue;
    is_cut = true;
    for (const int turn : {1, -1}) {
      const Sector sector(face, solid.leaves[node.leaf], turn);
      if (predicate(SectorView(shape, solid, leaf, sector).of_shape())) return true;
    }
  }
  return !is_cut && predicate(SectorView(shape, solid, leaf, Sector(face)).of_shape());
}

bool bounds(const LocalShape& shape, const Expression& solid, Leaf leaf) {
  return some_sector(shape, solid, leaf,
                     [](const View& view) { return view.at && !view.outward && view.leaf_stands; });
}

// Looking into every sector costs the cube of the number of leaves. Where this many seem to meet, it is mostly
// rounding that makes them, and no look is worth minutes: the point then counts as border, on the first leaf.
bool is_too_crowded(const LocalShape& shape) {
  constexpr std::size_t most_looked_into = 128;
  return shape.nodes.size() > most_looked_into;
}

}  // namespace

// If a region into which the planes cut space is missing from the shape, take a sector in its border. Outward
// of some leaf in the sector's plane there is that region itself or one in which fewer leaves are true: it is
// missing too. So looking outward finds whatever is missing.
bool is_interior(const LocalShape& shape, const Expression& solid) {
  if (shape.value != Value::open) return shape.value == Value::everything;
  if (is_too_crowded(shape)) return false;
  for (const LocalNode& node : shape.nodes) {
    if (node.kind == NodeKind::cell &&
        some_sector(shape, solid, node.leaf, [](const View& view) { return !view.outward; }))
      return false;
  }
  return true;
}

Leaf canonical_leaf(const LocalShape& shape, const Expression& solid, Candidates candidates) {
  std::optional<Leaf> first_candidate;
  for (const LocalNode& node : shape.nodes) {
    if (node.kind != NodeKind::cell) continue;
    if (candidates == Candidates::entered_leaves && !node.is_entered) continue;
    const bool looks_no_further = shape.nodes.size() == 1 || is_too_crowded(shape);
    if (looks_no_further || bounds(shape, solid, node.leaf)) return node.leaf;
    if (!first_candidate) first_candidate = node.leaf;
  }
  return *first_candidate;
}

}  // namespace groundtruth::fast
