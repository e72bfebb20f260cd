#include "explaining.hpp"

namespace groundtruth::explanation {
namespace {

class Change {
 public:
  Change(Leaf leaf, double offset) : leaf_(leaf), offset_(offset) {}

  Shape in(const Shape& shape) {
    return std::visit([this](const auto& expression) { return Shape{(*this)(expression)}; },
                      shape.expression);
  }

 private:
  HalfSpace operator()(const HalfSpace& leaf) {
    return {leaf.normal, next_++ == leaf_ ? offset_ : leaf.offset};
  }
  Union operator()(const Union& of) { return {each(of.operands)}; }
  Intersection operator()(const Intersection& of) { return {each(of.operands)}; }
  Covered operator()(const Covered& of) { return {of.material, std::make_shared<const Shape>(in(*of.over))}; }
  Painted operator()(const Painted& of) {
    return {of.material, of.where, std::make_shared<const Shape>(in(*of.over))};
  }
  template <typename Constant>
  Constant operator()(const Constant& constant) {
    return constant;
  }
  std::vector<Shape> each(const std::vector<Shape>& operands) {
    std::vector<Shape> all;
    for (const Shape& operand : operands) all.push_back(in(operand));
    return all;
  }

  Leaf leaf_;
  double offset_;
  Leaf next_ = 0;
};

}  // namespace

Shape with_offset(const Shape& shape, Leaf leaf, double offset) { return Change(leaf, offset).in(shape); }

}  // namespace groundtruth::explanation
