// Segments at the seams between pieces: the places of ghost contacts.

#include <algorithm>
#include <optional>
#include <vector>

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/entry_flavours.hpp>
#include <groundtruth/cases/entry_passing.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

// A point on an edge of the face in which two pieces abut.
struct SeamPoint {
  Vector point{};
  HalfSpace between;  // the plane of the seam
  HalfSpace face;     // the other plane of the edge
};

bool lies_on(const Corner& corner, std::size_t plane) {
  return std::find(corner.planes.begin(), corner.planes.end(), plane) != corner.planes.end();
}

// The edge of the piece between two corners of its face on `plane` that share another plane.
std::optional<SeamPoint> on_an_edge_of(const DetailedPiece& piece, std::size_t plane, Random& random) {
  std::vector<Corner> rim;
  for (const Corner& corner : piece.corners) {
    if (lies_on(corner, plane)) rim.push_back(corner);
  }
  if (rim.empty()) return std::nullopt;
  const Corner& begin = random.pick(rim);
  const std::size_t first = random.below(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t face = begin.planes[(first + i) % 3];
    if (face == plane) continue;
    for (const Corner& end : rim) {
      if (end.point == begin.point || !lies_on(end, face)) continue;
      return SeamPoint{between(begin.point, end.point, random.dyadic(0, 1, 3)), piece.planes[plane],
                       piece.planes[face]};
    }
  }
  return std::nullopt;
}

SeamPoint on_a_seam(const Landmarks& landmarks, Random& random) {
  if (!landmarks.seams.empty()) {
    const Seam& seam = random.pick(landmarks.seams);
    const DetailedPiece piece = detail(landmarks, seam.piece);
    const std::optional<SeamPoint> point = on_an_edge_of(piece, seam.plane, random);
    if (point) return *point;
  }
  const EdgePoint edge = on_an_edge(pick_piece(landmarks, random), random);
  return {edge.point, edge.plane, edge.plane};
}

}  // namespace

EntryAsk entry_across_seam(const Landmarks& landmarks, Random& random) {
  const SeamPoint target = on_a_seam(landmarks, random);
  // From the side of the piece: a house on the ground is seen from above.
  Vector direction = outward_direction(target.face.normal, random);
  for (int tries = 0; tries < 3 && dot(target.between.normal, direction) > 0; ++tries) {
    direction = outward_direction(target.face.normal, random);
  }
  return passing(target.point, direction, random);
}

EntryAsk entry_along_seam(const Landmarks& landmarks, Random& random) {
  const SeamPoint target = on_a_seam(landmarks, random);
  return passing(target.point, direction_in_plane(target.between.normal, random), random);
}

EntryAsk entry_over_seam(const Landmarks& landmarks, Random& random) {
  const SeamPoint target = on_a_seam(landmarks, random);
  return passing(target.point, direction_in_plane(target.face.normal, random), random);
}

}  // namespace groundtruth::cases
