#pragma once
// A scene made ready for many asks.

#include <cstddef>
#include <optional>
#include <vector>

#include <groundtruth/as_written/expression.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::as_written {

// A material that holds where `region` does; `material P over S` has everything as its region.
struct Paint {
  MaterialIndex material = 0;
  Expression region;
  std::optional<std::size_t> outer;  // the place in `Scene::paints` of the next one on the way to the root
};

// Owns all it needs. Not changed by asks: threads may share one. Its nesting costs stack, as the shape's
// does.
class Scene {
 public:
  // Not explicit: a lone ask may be put to a plain scene, at the cost of this preparation.
  Scene(const groundtruth::Scene& scene);

  const Expression& solid() const { return solid_; }
  const std::vector<Paint>& paints() const { return paints_; }

  // The place in paints() of the innermost paint over a leaf; nothing if it has none.
  std::optional<std::size_t> innermost_paint(Leaf leaf) const { return innermost_paint_[leaf]; }

  const Material& material(MaterialIndex index) const { return materials_[index]; }

 private:
  Expression solid_;
  std::vector<Paint> paints_;
  std::vector<std::optional<std::size_t>> innermost_paint_;  // by leaf
  std::vector<Material> materials_;
};

}  // namespace groundtruth::as_written
