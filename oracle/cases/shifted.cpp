#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {

Scene shifted(const Scene& scene, const Vector& offset) {
  return {scene.materials, with_each_plane(scene.shape, [&](const HalfSpace& plane) {
            return HalfSpace{plane.normal, plane.offset + dot(plane.normal, offset)};
          })};
}

}  // namespace groundtruth::cases
