#include "standing.hpp"

#include <algorithm>
#include <cmath>

#include "leaves.hpp"

namespace groundtruth::judge {
namespace {

struct Height {
  long double over_plane = 0;
  long double error = 0;  // it may be off by as much

  Height(const HalfSpace& plane, const Vector& place) : over_plane(-static_cast<long double>(plane.offset)) {
    long double terms = std::fabs(over_plane);
    for (std::size_t i = 0; i < 3; ++i) {
      const long double term = static_cast<long double>(plane.normal[i]) * place[i];
      over_plane += term;
      terms += std::fabs(term) + std::fabs(plane.normal[i]) * 0x1p-1070L;
    }
    error = 1e-15L * terms;
  }
};

class Standing {
 public:
  explicit Standing(const Vector& place) : place_(place) {}

  // Requires that all that the shape is met with may hold the place.
  void walk(const Shape& shape) {
    std::visit([this](const auto& expression) { walk(expression); }, shape.expression);
  }

  std::vector<Leaf> found;

 private:
  void walk(const HalfSpace& plane) {
    const Height height(plane, place_);
    if (std::fabs(height.over_plane) <= height.error) found.push_back(next_);
    ++next_;
  }
  void walk(const Union& of) {
    for (const Shape& operand : of.operands) walk(operand);
  }
  void walk(const Intersection& of) {
    std::vector<bool> holds;
    for (const Shape& operand : of.operands) holds.push_back(may_hold(operand));
    const auto missing = std::count(holds.begin(), holds.end(), false);
    for (std::size_t i = 0; i < holds.size(); ++i) {
      if (missing == (holds[i] ? 0 : 1))
        walk(of.operands[i]);
      else
        next_ += leaf_count(of.operands[i]);
    }
  }
  void walk(const Covered& of) { walk(*of.over); }
  void walk(const Painted& of) { walk(*of.over); }
  void walk(const Everything&) {}
  void walk(const Nothing&) {}

  bool may_hold(const Shape& shape) const {
    return std::visit([&](const auto& expression) { return may_hold(expression); }, shape.expression);
  }
  bool may_hold(const HalfSpace& plane) const {
    const Height height(plane, place_);
    return height.over_plane <= height.error;
  }
  bool may_hold(const Union& of) const {
    return std::any_of(of.operands.begin(), of.operands.end(),
                       [&](const Shape& one) { return may_hold(one); });
  }
  bool may_hold(const Intersection& of) const {
    return std::all_of(of.operands.begin(), of.operands.end(),
                       [&](const Shape& one) { return may_hold(one); });
  }
  bool may_hold(const Covered& of) const { return may_hold(*of.over); }
  bool may_hold(const Painted& of) const { return may_hold(*of.over); }
  bool may_hold(const Everything&) const { return true; }
  bool may_hold(const Nothing&) const { return false; }

  const Vector& place_;
  Leaf next_ = 0;
};

}  // namespace

std::vector<Leaf> leaves_that_may_stand(const Shape& shape, const Vector& place) {
  Standing standing(place);
  standing.walk(shape);
  return std::move(standing.found);
}

}  // namespace groundtruth::judge
