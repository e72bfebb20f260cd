#include <groundtruth/fast/face.hpp>

namespace groundtruth::fast {

namespace {

template <class Number>
class LocalShapeBuilder {
 public:
  LocalShapeBuilder(const Expression& solid, const Segment<Number>& segment, Number lambda, LocalNodes& nodes)
      : solid_(solid), segment_(segment), lambda_(lambda), nodes_(nodes) {}

  Value add(const Node* node) {
    switch (node->kind) {
      case NodeKind::nothing:
        return Value::nothing;
      case NodeKind::everything:
        return Value::everything;
      case NodeKind::cell:
        return add_operator(NodeKind::intersection_of, node->first_leaf, node->end_leaf,
                            [&](std::uint32_t& leaf) { return add_leaf(leaf++); });
      case NodeKind::union_of:
      case NodeKind::intersection_of:
        break;
    }
    return add_operator(node->kind, node + 1, node + node->size, [&](const Node*& operand) {
      const Value value = add(operand);
      operand += operand->size;
      return value;
    });
  }

 private:
  Value add_leaf(std::uint32_t leaf) {
    const HalfSpace& half_space = solid_.leaves[leaf];
    const Approach<Number> approach = segment_.approach(half_space);
    const Side side = approach.side_at(lambda_);
    if (side == Side::outside) return Value::nothing;
    if (side == Side::inside || half_space.normal == Vector{}) return Value::everything;
    nodes_.push_back({.kind = NodeKind::cell, .size = 1, .leaf = leaf, .is_entered = approach.enters()});
    return Value::open;
  }

  template <class Position, class AddNext>
  Value add_operator(NodeKind kind, Position position, Position end, AddNext add_next) {
    const bool is_union = kind == NodeKind::union_of;
    const Value absorbing = is_union ? Value::everything : Value::nothing;
    const Value neutral = is_union ? Value::nothing : Value::everything;
    const std::size_t place = nodes_.size();
    nodes_.push_back({.kind = kind, .size = 1, .leaf = 0, .is_entered = false});
    while (position != end) {
      if (add_next(position) != absorbing) continue;
      nodes_.resize(place);
      return absorbing;
    }
    const std::size_t below = nodes_.size() - place - 1;
    if (below == 0) {
      nodes_.resize(place);
      return neutral;
    }
    if (nodes_[place + 1].size == below)
      nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(place));
    else
      nodes_[place].size = static_cast<std::uint32_t>(below + 1);
    return Value::open;
  }

  const Expression& solid_;
  const Segment<Number>& segment_;
  const Number lambda_;
  LocalNodes& nodes_;
};

}  // namespace

template <class Number>
LocalShape local_shape(const Expression& solid, const Segment<Number>& segment, Number lambda) {
  LocalShape shape;
  shape.value = LocalShapeBuilder<Number>(solid, segment, lambda, shape.nodes).add(solid.nodes.data());
  return shape;
}

template LocalShape local_shape(const Expression&, const Segment<double>&, double);
template LocalShape local_shape(const Expression&, const Segment<Wide>&, Wide);

}  // namespace groundtruth::fast
