#include <groundtruth/explanation/solid.hpp>

#include <algorithm>

namespace groundtruth::explanation {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

// Walks a shape in preorder, and keeps what is not constant.
class Builder {
 public:
  explicit Builder(const TruthOfPlane& truth) : truth_(truth) {}

  Truth add(const Shape& shape) {
    return std::visit(
        Overloaded{[](const Everything&) { return Truth::yes; }, [](const Nothing&) { return Truth::no; },
                   [this](const HalfSpace& leaf) { return add_leaf(leaf); },
                   [this](const Union& of) {
                     return add_all({Part::united, 0, 0, 0, nullptr}, of.operands);
                   },
                   [this](const Intersection& of) {
                     return add_all({Part::intersected, 0, 0, 0, nullptr}, of.operands);
                   },
                   [this](const Covered& of) {
                     return add_coat({Part::covered, 0, 0, of.material, nullptr}, *of.over);
                   },
                   [this](const Painted& of) {
                     return add_coat({Part::painted, 0, 0, of.material, of.where}, *of.over);
                   }},
        shape.expression);
  }
  Solid take() && { return std::move(solid_); }

 private:
  Truth add_leaf(const HalfSpace& leaf) {
    Plane plane{next_leaf_++, rational(leaf.normal), Rational(leaf.offset), leaf.normal};
    const Truth truth = truth_(plane);
    if (truth != Truth::unknown) return truth;
    solid_.nodes.push_back({Part::leaf, solid_.nodes.size() + 1, solid_.planes.size(), 0, nullptr});
    solid_.planes.push_back(std::move(plane));
    return truth;
  }

  Truth add_all(const Node& node, const std::vector<Shape>& operands) {
    const Truth swallowing = node.part == Part::united ? Truth::yes : Truth::no;
    const std::size_t start = solid_.nodes.size(), planes = solid_.planes.size();
    solid_.nodes.push_back(node);
    Truth result = node.part == Part::united ? Truth::no : Truth::yes;
    bool swallowed = false;
    for (const Shape& operand : operands) {  // to the end, so that leaves keep their numbers
      const Truth truth = add(operand);
      if (truth == swallowing) swallowed = true;
      if (truth == Truth::unknown) result = Truth::unknown;
    }
    if (swallowed) result = swallowing;
    return finish(start, planes, result);
  }

  Truth add_coat(const Node& node, const Shape& over) {
    const std::size_t start = solid_.nodes.size(), planes = solid_.planes.size();
    solid_.nodes.push_back(node);
    return finish(start, planes, add(over));
  }

  Truth finish(std::size_t start, std::size_t planes, Truth result) {
    if (result == Truth::unknown) {
      solid_.nodes[start].end = solid_.nodes.size();
    } else {
      solid_.nodes.resize(start);
      solid_.planes.resize(planes);
    }
    return result;
  }

  const TruthOfPlane& truth_;
  Solid solid_;
  Leaf next_leaf_ = 0;
};

Truth evaluate(const Solid& solid, std::size_t at, const std::function<Truth(std::size_t)>& truth) {
  const Node& node = solid.nodes[at];
  switch (node.part) {
    case Part::everything:
      return Truth::yes;
    case Part::nothing:
      return Truth::no;
    case Part::leaf:
      return truth(node.plane);
    case Part::covered:
    case Part::painted:
      return evaluate(solid, at + 1, truth);
    default:
      break;
  }
  const Truth swallowing = node.part == Part::united ? Truth::yes : Truth::no;
  Truth result = node.part == Part::united ? Truth::no : Truth::yes;
  for (std::size_t operand = at + 1; operand < node.end; operand = solid.nodes[operand].end) {
    const Truth one = evaluate(solid, operand, truth);
    if (one == swallowing) return swallowing;
    if (one == Truth::unknown) result = Truth::unknown;
  }
  return result;
}

void mark_standing(const Solid& solid, std::size_t at, const std::function<Truth(std::size_t)>& truth,
                   std::vector<bool>& stands) {
  if (evaluate(solid, at, truth) != Truth::unknown) return;
  const Node& node = solid.nodes[at];
  if (node.part == Part::leaf) stands[node.plane] = true;
  for (std::size_t operand = at + 1; operand < node.end; operand = solid.nodes[operand].end)
    mark_standing(solid, operand, truth, stands);
}

void append_planes(const Shape& shape, std::vector<Plane>& planes) {
  const auto each = [&](const std::vector<Shape>& operands) {
    for (const Shape& operand : operands) append_planes(operand, planes);
  };
  std::visit(
      Overloaded{
          [&](const HalfSpace& leaf) {
            planes.push_back({planes.size(), rational(leaf.normal), Rational(leaf.offset), leaf.normal});
          },
          [&](const Union& of) { each(of.operands); }, [&](const Intersection& of) { each(of.operands); },
          [&](const Covered& of) { append_planes(*of.over, planes); },
          [&](const Painted& of) { append_planes(*of.over, planes); }, [](const auto&) {}},
      shape.expression);
}

}  // namespace

std::vector<Plane> planes_of(const Shape& shape) {
  std::vector<Plane> planes;
  append_planes(shape, planes);
  return planes;
}

Solid solid_where(const Shape& shape, const TruthOfPlane& truth) {
  Builder builder(truth);
  const Truth whole = builder.add(shape);
  Solid solid = std::move(builder).take();
  if (whole != Truth::unknown)
    solid.nodes.push_back({whole == Truth::yes ? Part::everything : Part::nothing, 1, 0, 0, nullptr});
  return solid;
}

std::vector<bool> lit(const Solid& solid, const std::vector<bool>& truth) {
  const auto of_plane = [&](std::size_t plane) { return truth[plane] ? Truth::yes : Truth::no; };
  std::vector<bool> result;
  for (std::size_t at = 0; at < solid.nodes.size(); ++at)
    result.push_back(evaluate(solid, at, of_plane) == Truth::yes);
  return result;
}

Truth evaluate(const Solid& solid, const std::function<Truth(std::size_t)>& truth) {
  return evaluate(solid, 0, truth);
}

std::vector<bool> standing(const Solid& solid, const std::function<Truth(std::size_t)>& truth) {
  std::vector<bool> stands(solid.planes.size());
  mark_standing(solid, 0, truth, stands);
  return stands;
}

bool contains(const Shape& shape, const RationalVector& point) {
  const auto in = [&](const Shape& part) { return contains(part, point); };
  return std::visit(
      Overloaded{
          [](const Everything&) { return true; }, [](const Nothing&) { return false; },
          [&](const HalfSpace& leaf) { return dot(rational(leaf.normal), point) <= Rational(leaf.offset); },
          [&](const Union& of) { return std::any_of(of.operands.begin(), of.operands.end(), in); },
          [&](const Intersection& of) { return std::all_of(of.operands.begin(), of.operands.end(), in); },
          [&](const Covered& of) { return in(*of.over); }, [&](const Painted& of) { return in(*of.over); }},
      shape.expression);
}

std::optional<MaterialIndex> material_at(const Solid& solid, std::size_t plane, const RationalVector& point) {
  std::size_t leaf = 0;
  while (solid.nodes[leaf].part != Part::leaf || solid.nodes[leaf].plane != plane) ++leaf;
  for (std::size_t at = 0; at < leaf; ++at) {
    const Node& node = solid.nodes[at];
    if (node.end <= leaf) continue;  // not above the leaf
    const bool is_coat =
        node.part == Part::covered || (node.part == Part::painted && contains(*node.where, point));
    if (is_coat) return node.material;
  }
  return std::nullopt;
}

}  // namespace groundtruth::explanation
