#include <groundtruth/fast/step_ground.hpp>

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
  const HitPlace place{result.lower(), result.upper, face, std::nullopt};
  const auto material = material_by_doubles(scene, probe, place);
  if (!material) return std::nullopt;
  return FaceFound{face.leaf, *material};
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
