#include <algorithm>

#include <groundtruth/definition/expression.hpp>

namespace groundtruth::definition {
namespace {

WholeHalfSpace in_integers(const HalfSpace& half_space) {
  const Triple<Rational> normal = rational(half_space.normal);
  const Rational offset = rational(half_space.offset);
  Integer common = denominator(offset);
  for (const Rational& n : normal) common = lcm(common, denominator(n));
  const auto scaled = [&](const Rational& x) { return Integer(numerator(x) * (common / denominator(x))); };
  return {{scaled(normal[0]), scaled(normal[1]), scaled(normal[2])}, scaled(offset), half_space.normal};
}

class Writer {
 public:
  explicit Writer(Expression& target) : target_(target) {}

  void write(const Shape& shape, std::size_t parent) {
    std::visit([&](const auto& part) { write_part(part, parent); }, shape.expression);
  }

 private:
  std::size_t append(Node::Kind kind, std::size_t parent, std::size_t operands = 0) {
    Node node;
    node.kind = kind;
    node.parent = parent;
    node.operands = operands;
    target_.nodes.push_back(node);
    return target_.nodes.size() - 1;
  }

  void write_operands(const std::vector<Shape>& operands, Node::Kind kind, std::size_t parent) {
    const std::size_t self = append(kind, parent, operands.size());
    for (const Shape& operand : operands) write(operand, self);
  }

  void write_part(const Nothing&, std::size_t parent) { append(Node::Kind::nothing, parent); }
  void write_part(const Everything&, std::size_t parent) { append(Node::Kind::everything, parent); }

  void write_part(const HalfSpace& half_space, std::size_t parent) {
    const std::size_t self = append(Node::Kind::leaf, parent);
    target_.nodes[self].leaf = target_.half_spaces.size();
    target_.half_spaces.push_back(in_integers(half_space));
    target_.node_of_leaf.push_back(self);
  }

  void write_part(const Union& part, std::size_t parent) {
    write_operands(part.operands, Node::Kind::any_operand, parent);
  }

  void write_part(const Intersection& part, std::size_t parent) {
    write_operands(part.operands, Node::Kind::every_operand, parent);
  }

  void write_part(const Covered& part, std::size_t parent) {
    const std::size_t self = append(Node::Kind::every_operand, parent, 1);
    target_.nodes[self].material = part.material;
    write(*part.over, self);
  }

  void write_part(const Painted& part, std::size_t parent) {
    const std::size_t self = append(Node::Kind::every_operand, parent, 1);
    target_.nodes[self].material = part.material;
    target_.nodes[self].region = target_.regions.size();
    target_.regions.push_back(expression_of(*part.where));
    write(*part.over, self);
  }

  Expression& target_;
};

bool has_no_plane(const WholeHalfSpace& half_space) {
  return std::all_of(half_space.normal.begin(), half_space.normal.end(),
                     [](const Integer& n) { return n.is_zero(); });
}

}  // namespace

Expression expression_of(const Shape& shape) {
  Expression result;
  Writer(result).write(shape, 0);
  return result;
}

Heights heights(const Expression& expression, const Point& point) {
  Heights result;
  result.reserve(expression.half_spaces.size());
  for (const WholeHalfSpace& h : expression.half_spaces)
    result.push_back(dot(h.normal, point.numerators) - Whole(Integer(h.offset * point.weight)));
  return result;
}

Sides sides(const Expression& expression, const Heights& heights) {
  Sides result(heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const int sign = heights[i].sign();
    const bool everything = sign == 0 && has_no_plane(expression.half_spaces[i]);
    result[i] = static_cast<signed char>(everything ? -1 : sign);
  }
  return result;
}

std::vector<bool> membership(const Expression& expression, const Sides& sides, Reading reading) {
  const std::vector<Node>& nodes = expression.nodes;
  std::vector<bool> member(nodes.size());
  std::vector<std::size_t> member_operands(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    switch (nodes[i].kind) {
      case Node::Kind::nothing:
        member[i] = false;
        break;
      case Node::Kind::everything:
        member[i] = true;
        break;
      case Node::Kind::leaf:
        member[i] = holds(sides[nodes[i].leaf], reading);
        break;
      case Node::Kind::any_operand:
        member[i] = member_operands[i] > 0;
        break;
      case Node::Kind::every_operand:
        member[i] = member_operands[i] == nodes[i].operands;
        break;
    }
    if (i > 0 && member[i]) ++member_operands[nodes[i].parent];
  }
  return member;
}

bool is_member(const Expression& expression, const Point& point) {
  return membership(expression, sides(expression, heights(expression, point)), Reading::closed).front();
}

}  // namespace groundtruth::definition
