#include <groundtruth/as_written/entry_point.hpp>
#include <groundtruth/as_written/local_shape.hpp>
#include <groundtruth/as_written/recursion.hpp>
#include <groundtruth/as_written/segment.hpp>

namespace groundtruth::as_written {
namespace {

std::optional<MaterialIndex> material_of(const Scene& scene, Leaf leaf, const Segment& segment,
                                         double lambda) {
  std::optional<MaterialIndex> outermost;
  for (auto place = scene.innermost_paint(leaf); place; place = scene.paints()[*place].outer) {
    const Paint& paint = scene.paints()[*place];
    if (segment.lies_in(paint.region, 0, lambda)) {
      outermost = paint.material;
    }
  }
  return outermost;
}

// The face that the contract names, or null for an interior point. Where the recursion was led to a place at
// which the solid is not (an erratum), there is no such face, and the recursion's own is all there is.
const Node* contracted_face(const Scene& scene, const Segment& segment, const Reached& reached) {
  const Local local = local_shape(scene.solid(), segment, reached.lambda);
  switch (local.neighbourhood) {
    case Neighbourhood::face:
      return local.face;
    case Neighbourhood::solid:
      return reached.lambda == segment.first() ? nullptr : reached.face;
    case Neighbourhood::empty:
      return reached.face;
  }
  return reached.face;
}

}  // namespace

EntryAnswer entry_point(const Scene& scene, const EntryAsk& ask, const Errata& errata) {
  const Segment segment(ask);
  const std::optional<Reached> reached = first_reached(scene.solid(), segment, errata);
  if (!reached || reached->lambda > segment.last()) {
    return Miss{};
  }
  const Node* face =
      errata.has(Erratum::normal_by_order) ? reached->face : contracted_face(scene, segment, *reached);
  if (face == nullptr) {
    return Inside{reached->lambda};
  }
  return Border{reached->lambda, face->leaf, face->half_space.normal,
                material_of(scene, face->leaf, segment, reached->lambda)};
}

}  // namespace groundtruth::as_written
