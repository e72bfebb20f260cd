#include <groundtruth/fast/divide.hpp>

namespace groundtruth::fast {

namespace {

enum class Value { nothing, open, everything };

class Folder {
 public:
  explicit Folder(const Expression& solid) : solid_(solid) { nodes_.reserve(solid.nodes.size()); }

  std::vector<Node> result() {
    const Value value = add(solid_.nodes.data());
    if (value != Value::open)
      nodes_ = {{.kind = value == Value::nothing ? NodeKind::nothing : NodeKind::everything}};
    return std::move(nodes_);
  }

 private:
  Value add(const Node* node) {
    switch (node->kind) {
      case NodeKind::nothing:
        return Value::nothing;
      case NodeKind::everything:
        return Value::everything;
      case NodeKind::cell:
        return add_cell(*node);
      case NodeKind::union_of:
      case NodeKind::intersection_of:
        break;
    }
    return add_operator(node);
  }

  // A leaf with a zero normal cuts its cell in two.
  Value add_cell(const Node& node) {
    const std::size_t place = nodes_.size();
    bool extends_last = false;
    for (std::uint32_t leaf = node.first_leaf; leaf != node.end_leaf; ++leaf) {
      const HalfSpace& half_space = solid_.leaves[leaf];
      if (half_space.normal == Vector{}) {
        if (half_space.offset < 0) {
          nodes_.resize(place);
          return Value::nothing;
        }
        extends_last = false;
        continue;
      }
      if (extends_last)
        ++nodes_.back().end_leaf;
      else
        nodes_.push_back({NodeKind::cell, 1, leaf, leaf + 1});
      extends_last = true;
    }
    const std::size_t cells = nodes_.size() - place;
    if (cells == 0) return Value::everything;
    if (cells > 1)
      nodes_.insert(nodes_.begin() + static_cast<std::ptrdiff_t>(place),
                    {NodeKind::intersection_of, static_cast<std::uint32_t>(cells + 1), 0, 0});
    return Value::open;
  }

  Value add_operator(const Node* node) {
    const Value absorbing = node->kind == NodeKind::union_of ? Value::everything : Value::nothing;
    const std::size_t place = nodes_.size();
    nodes_.push_back({.kind = node->kind});
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const std::size_t start = nodes_.size();
      if (add(operand) == absorbing) {
        nodes_.resize(place);
        return absorbing;
      }
      // What has become an operator of the same kind gives its operands away.
      if (start < nodes_.size() && nodes_[start].kind == node->kind)
        nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(start));
    }
    const std::size_t below = nodes_.size() - place - 1;
    if (below == 0) {
      nodes_.resize(place);
      return absorbing == Value::everything ? Value::nothing : Value::everything;
    }
    if (nodes_[place + 1].size == below)
      nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(place));
    else
      nodes_[place].size = static_cast<std::uint32_t>(below + 1);
    return Value::open;
  }

  const Expression& solid_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<Node> fold(const Expression& solid) { return Folder(solid).result(); }

}  // namespace groundtruth::fast
