#include <groundtruth/fast/step_ground.hpp>

#include <groundtruth/fast/quick_touch.hpp>
#include <groundtruth/fast/step_strut.hpp>

namespace groundtruth::fast {

namespace {

struct StrutHit {
  QuickTouch::Kind kind = QuickTouch::uncertain;
  Face face{};  // of a surface
  std::optional<MaterialIndex> material{};
};

[[gnu::always_inline]] inline StrutHit hit_along(const Scene& scene, const RangeEnds& ends) {
  StrutHit hit;
  const Probe probe(ends);
  SearchResult result;
  search(scene, probe, result);
  if (result.starts_inside) {
    hit.kind = QuickTouch::broken;
    return hit;
  }
  if (result.contenders.empty()) {
    hit.kind = QuickTouch::nothing;
    return hit;
  }
  hit.face = sole_face(scene, probe, result);
  if (hit.face.leaf == no_leaf || !(result.lower() > 0 && result.upper < 1)) return hit;
  auto material = sure_material(hit.face);
  if (!material)
    material = material_by_doubles(scene, probe, {result.lower(), result.upper, hit.face, nullptr});
  if (!material) return hit;
  hit.material = *material;
  hit.kind = QuickTouch::surface;
  return hit;
}

}  // namespace

std::optional<FaceAlong> face_along(const Scene& scene, const RangeEnds& ends) {
  const StrutHit hit = hit_along(scene, ends);
  if (hit.kind == QuickTouch::uncertain) return std::nullopt;
  if (hit.kind == QuickTouch::nothing) return NoContact{};
  if (hit.kind == QuickTouch::broken) return StepFailure::wheel_broken;
  return FaceFound{hit.face.leaf, hit.face.half_space, hit.material};
}

void quick_touch(const Scene& scene, const RangeEnds& ends, const std::string& tyre, QuickTouch& touch) {
  const StrutHit hit = hit_along(scene, ends);
  touch.kind = hit.kind;
  if (hit.kind != QuickTouch::surface) return;
  touch.plane = hit.face.half_space;
  if (!hit.material) return;
  const Material& material = scene.materials()[*hit.material];
  touch.maximum_force = material.maximum_force;
  // Looking at all of a few is quicker than to search them.
  for (const auto& [name, friction] : material.friction_by_tyre)
    if (name == tyre) touch.friction = &friction;
}

exact_stage::ExpressionView SolidAlongStrut::along(const RangeEnds& ends) {
  static constexpr Node everything{.kind = NodeKind::everything};
  probe_.emplace(ends);
  SearchResult result;
  search(scene_, *probe_, result);
  if (result.starts_inside) return {{&everything, 1}, {}, {}};
  open_.emplace(scene_, *probe_);
  open_->assemble(result.contenders.data(), result.contenders.data() + result.contenders.size(),
                  result.upper);
  return open_->view();
}

}  // namespace groundtruth::fast
