// Segments through, in and along the features of one piece.

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/entry_flavours.hpp>
#include <groundtruth/cases/entry_passing.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

// Mostly from the outside; else from anywhere, so that segments graze, leave and stay out.
Vector approach(const Vector& normal, Random& random) {
  const bool from_outside = !random.one_in(4);
  return from_outside ? outward_direction(normal, random) : short_direction(random);
}

}  // namespace

EntryAsk entry_through_face(const Landmarks& landmarks, Random& random) {
  const FacePoint target = on_a_face(pick_piece(landmarks, random), random);
  return passing(target.point, approach(target.plane.normal, random), random);
}

EntryAsk entry_through_edge(const Landmarks& landmarks, Random& random) {
  const EdgePoint target = on_an_edge(pick_piece(landmarks, random), random);
  return passing(target.point, approach(target.plane.normal, random), random);
}

EntryAsk entry_through_corner(const Landmarks& landmarks, Random& random) {
  const FacePoint target = at_a_corner(pick_piece(landmarks, random), random);
  return passing(target.point, approach(target.plane.normal, random), random);
}

EntryAsk entry_through_crossing(const Landmarks& landmarks, Random& random) {
  const FacePoint target = at_a_crossing(landmarks, random);
  return passing(target.point, approach(target.plane.normal, random), random);
}

EntryAsk entry_in_face_plane(const Landmarks& landmarks, Random& random) {
  const FacePoint target = on_a_face(pick_piece(landmarks, random), random);
  return passing(target.point, direction_in_plane(target.plane.normal, random), random);
}

EntryAsk entry_along_edge(const Landmarks& landmarks, Random& random) {
  const EdgePoint target = on_an_edge(pick_piece(landmarks, random), random);
  const double sign = random.sign();
  const double part = random.dyadic(1, 4, 0) / 4;
  return passing(target.point, times(sign * part, target.direction), random);
}

}  // namespace groundtruth::cases
