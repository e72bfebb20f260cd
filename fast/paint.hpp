#pragma once
// The material of the face that an ask hits. Not installed.

#include <optional>

#include <groundtruth/fast/cell.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/stage.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// The material that a face bears wherever it is hit; nothing: rules decide.
inline std::optional<std::optional<MaterialIndex>> sure_material(const Face& face) {
  const std::uint32_t material = face.material.material;
  if (material == CellMaterial::by_rules) return std::nullopt;
  if (material == CellMaterial::none) return std::optional<MaterialIndex>();
  return MaterialIndex{material};
}

// Where a range meets the solid: at lower <= s <= upper, on the border of a face. A view: a processor waits
// where what was just written is copied.
struct HitPlace {
  double lower;
  double upper;
  const Face& face;          // the canonical one
  const HalfSpace* crossed;  // one that the range crosses there; null: the range's start
};

struct FaceMaterial {
  std::optional<MaterialIndex> material;
  Stage stage = Stage::doubles;  // exact if one region at least needed it
};

// The outermost rule over the leaf that holds at the place (SPEC section 2), exactly. Looks at rules even
// where the face bears its material.
FaceMaterial material_at(const Scene& scene, const Probe& probe, const EntryAsk& ask, const HitPlace& place);

// The same for any range, if doubles can tell.
std::optional<std::optional<MaterialIndex>> material_by_doubles(const Scene& scene, const Probe& probe,
                                                                const HitPlace& place);

}  // namespace groundtruth::fast
