// Ranges that start or end exactly on a feature, and ranges and segments that are a single point.

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/entry_flavours.hpp>
#include <groundtruth/cases/entry_passing.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

// Any way, or within the face: there it starts to matter which leaves bound the solid.
Vector heading_from(const Vector& normal, Random& random) {
  return random.one_in(3) ? direction_in_plane(normal, random) : short_direction(random);
}

}  // namespace

EntryAsk entry_start_on_face(const Landmarks& landmarks, Random& random) {
  const FacePoint start = on_a_face(pick_piece(landmarks, random), random);
  return starting_at(start.point, heading_from(start.plane.normal, random), random);
}

EntryAsk entry_start_on_edge(const Landmarks& landmarks, Random& random) {
  const EdgePoint start = on_an_edge(pick_piece(landmarks, random), random);
  const Vector heading =
      random.one_in(4) ? times(random.sign(), start.direction) : heading_from(start.plane.normal, random);
  return starting_at(start.point, heading, random);
}

EntryAsk entry_start_on_corner(const Landmarks& landmarks, Random& random) {
  const FacePoint start = at_a_corner(pick_piece(landmarks, random), random);
  return starting_at(start.point, heading_from(start.plane.normal, random), random);
}

EntryAsk entry_start_inside(const Landmarks& landmarks, Random& random) {
  const Vector start = in_the_piece(pick_piece(landmarks, random), random);
  return starting_at(start, short_direction(random), random);
}

EntryAsk entry_end_on_border(const Landmarks& landmarks, Random& random) {
  const Feature end = any_feature(landmarks, random);
  return ending_at(end.point, times(-1, outward_direction(end.normal, random)), random);
}

EntryAsk entry_point(const Landmarks& landmarks, Random& random) {
  const Vector point = random.one_in(4) ? in_bounds(landmarks, random) : any_feature(landmarks, random).point;
  EntryAsk ask{point, point, 0, 1};
  if (random.one_in(4)) ask.lambda_first = ask.lambda_last = random.dyadic(-2, 2, 2);
  return ask;
}

EntryAsk entry_instant(const Landmarks& landmarks, Random& random) {
  const Feature target = any_feature(landmarks, random);
  EntryAsk ask = starting_at(target.point, short_direction(random), random);
  ask.lambda_last = ask.lambda_first;
  return ask;
}

}  // namespace groundtruth::cases
