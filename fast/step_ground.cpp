#include <groundtruth/fast/step_ground.hpp>

#include <groundtruth/fast/quick_touch.hpp>
#include <groundtruth/fast/step_strut.hpp>

namespace groundtruth::fast {

std::optional<FaceAlong> face_along(const Scene& scene, const RangeEnds& ends) {
  const Probe probe(ends);
  SearchResult result;
  search(scene, probe, result);
  if (result.starts_inside) return StepFailure::wheel_broken;
  if (result.contenders.empty()) return NoContact{};
  const Face face = sole_face(scene, probe, result);
  if (face.leaf == no_leaf || !(result.lower() > 0 && result.upper < 1)) return std::nullopt;
  auto material = sure_material(face);
  if (!material) material = material_by_doubles(scene, probe, {result.lower(), result.upper, face, nullptr});
  if (!material) return std::nullopt;
  return FaceFound{face.leaf, face.half_space, *material};
}

std::optional<QuickTouch> quick_touch(const Scene& scene, const RangeEnds& ends, const std::string& tyre) {
  const auto found = face_along(scene, ends);
  if (!found) return std::nullopt;
  QuickTouch touch;
  if (std::holds_alternative<NoContact>(*found)) return touch;
  if (std::holds_alternative<StepFailure>(*found)) {
    touch.kind = QuickTouch::broken;
    return touch;
  }
  const auto& face = std::get<FaceFound>(*found);
  touch.kind = QuickTouch::surface;
  touch.plane = face.plane;
  if (!face.material) return touch;
  const Material& material = scene.materials()[*face.material];
  touch.maximum_force = material.maximum_force;
  // Looking at all of a few is quicker than to search them.
  for (const auto& [name, friction] : material.friction_by_tyre)
    if (name == tyre) touch.friction = &friction;
  return touch;
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
