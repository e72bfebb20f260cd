#include <groundtruth/cases/scene_changes.hpp>

#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include <groundtruth/cases/shape_parts.hpp>

#include "number_changes.hpp"

namespace groundtruth::cases {
namespace {

HalfSpace changed_plane(HalfSpace plane, Random& random) {
  switch (random.below(5)) {
    case 0: {  // the same plane at another length
      const double scale = random.one_in(2) ? 2 : 3;
      for (double& coordinate : plane.normal) coordinate *= scale;
      plane.offset *= scale;
      break;
    }
    case 1:
      plane.normal = changed_vector(plane.normal, random);
      break;
    case 2:  // its other side
      for (double& coordinate : plane.normal) coordinate = 0 - coordinate;
      plane.offset = 0 - plane.offset;
      break;
    default:
      plane.offset = changed_number(plane.offset, random);
  }
  return plane;
}

bool is_finite(const HalfSpace& plane) {
  return std::isfinite(plane.normal[0]) && std::isfinite(plane.normal[1]) && std::isfinite(plane.normal[2]) &&
         std::isfinite(plane.offset);
}

class Change {
 public:
  explicit Change(Random& random, std::size_t materials) : random_(random), materials_(materials) {}

  // Changes the shape itself, or one of its parts: the further down the more leaves are there.
  Shape operator()(const Shape& shape) {
    return std::visit([&](const auto& expression) { return here_or_below(expression); }, shape.expression);
  }

 private:
  template <typename Constant>
  Shape here_or_below(const Constant& constant) {
    return random_.one_in(2) ? Shape{constant} : wrapped(Shape{constant});
  }
  Shape here_or_below(const HalfSpace& plane) {
    const HalfSpace other = changed_plane(plane, random_);
    if (!random_.one_in(5)) return is_finite(other) ? Shape{other} : Shape{plane};
    return wrapped({plane});
  }
  Shape here_or_below(const Union& all) { return of_operands(all); }
  Shape here_or_below(const Intersection& all) { return of_operands(all); }
  Shape here_or_below(const Covered& cover) {
    if (materials_ > 0 && random_.one_in(6)) return covered(random_.below(materials_), *cover.over);
    if (random_.one_in(8)) return *cover.over;
    return covered(cover.material, (*this)(*cover.over));
  }
  Shape here_or_below(const Painted& paint) {
    if (random_.one_in(8)) return *paint.over;
    if (random_.one_in(2)) return painted(paint.material, (*this)(*paint.where), *paint.over);
    return painted(paint.material, *paint.where, (*this)(*paint.over));
  }

  template <typename Operands>
  Shape of_operands(const Operands& all) {
    std::vector<Shape> operands = all.operands;
    if (operands.empty()) return wrapped(Shape{all});
    const std::size_t place = random_.below(operands.size());
    const auto at = operands.begin() + static_cast<std::ptrdiff_t>(place);
    switch (random_.below(10)) {
      case 0:
        operands.erase(at);
        break;
      case 1:
        if (leaf_count(*at) < 8) operands.push_back(*at);
        break;
      case 2:
        std::swap(*at, operands[random_.below(operands.size())]);
        break;
      case 3:
        return wrapped(Shape{all});
      case 4:
        return random_.one_in(2) ? union_of(std::move(operands)) : intersection_of(std::move(operands));
      default:
        *at = (*this)(*at);
    }
    return {Operands{std::move(operands)}};
  }

  Shape wrapped(Shape shape) {
    if (materials_ > 0 && random_.one_in(3)) return covered(random_.below(materials_), std::move(shape));
    return random_.one_in(2) ? union_of({std::move(shape)}) : intersection_of({std::move(shape)});
  }

  Random& random_;
  std::size_t materials_;
};

}  // namespace

Scene changed(const Scene& scene, Random& random) {
  return {scene.materials, Change(random, scene.materials.size())(scene.shape)};
}

}  // namespace groundtruth::cases
