#include <groundtruth/as_written/cone.hpp>
#include <groundtruth/as_written/local_shape.hpp>

#include <utility>

namespace groundtruth::as_written {
namespace {

// What is left of an expression at x(lambda) once leaves that do not pass through it are replaced by
// constants and these are simplified away.
class Simplifier {
 public:
  Simplifier(const Expression& expression, const Segment& segment, double lambda)
      : expression_(expression), segment_(segment), lambda_(lambda) {}

  Remains simplify(std::size_t node) {
    const Node& here = expression_[node];
    switch (here.operation) {
      case Operation::everything:
        return Remains::everything;
      case Operation::nothing:
        return Remains::nothing;
      case Operation::half_space:
        return simplify_half_space(here);
      case Operation::union_of:
        return simplify_operands(node, Remains::everything, Remains::nothing);
      case Operation::intersection_of:
        return simplify_operands(node, Remains::nothing, Remains::everything);
    }
    return Remains::nothing;
  }

  Cone take_cone() { return std::move(cone_); }

 private:
  Remains simplify_half_space(const Node& here) {
    switch (segment_.side(here.half_space, lambda_)) {
      case Side::inside:
        return Remains::everything;
      case Side::outside:
        return Remains::nothing;
      case Side::on:
        break;
    }
    cone_.push_back({Operation::half_space, cone_.size() + 1, &here});
    return Remains::some;
  }

  Remains simplify_operands(std::size_t node, Remains swallowing, Remains vanishing) {
    const std::size_t place = cone_.size();
    cone_.push_back({expression_[node].operation, 0, nullptr});
    for (std::size_t operand = node + 1; operand != expression_[node].end;
         operand = expression_[operand].end) {
      if (simplify(operand) == swallowing) {
        cone_.resize(place);
        return swallowing;
      }
    }
    if (cone_.size() == place + 1) {
      cone_.resize(place);
      return vanishing;
    }
    cone_[place].end = cone_.size();
    return Remains::some;
  }

  const Expression& expression_;
  const Segment& segment_;
  const double lambda_;
  Cone cone_;
};

}  // namespace

Local local_shape(const Expression& expression, const Segment& segment, double lambda) {
  Simplifier simplifier(expression, segment, lambda);
  switch (simplifier.simplify(0)) {
    case Remains::everything:
      return {Neighbourhood::solid, nullptr};
    case Remains::nothing:
      return {Neighbourhood::empty, nullptr};
    case Remains::some:
      break;
  }
  const Cone cone = simplifier.take_cone();
  if (lambda > segment.first()) {
    const Node* face = entered_face(cone, segment);
    return {face == nullptr ? Neighbourhood::empty : Neighbourhood::face, face};
  }
  const Node* face = start_face(cone);
  return {face == nullptr ? Neighbourhood::solid : Neighbourhood::face, face};
}

}  // namespace groundtruth::as_written
