#include <algorithm>
#include <cmath>

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/entry_passing.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

void set_unusual_range(EntryAsk& ask, Random& random) {
  double first = random.dyadic(-3, 3, 4);
  double last = random.dyadic(-3, 3, 4);
  if (random.one_in(4)) last = first + random.magnitude(-60, -10);
  if (random.one_in(8)) first = -random.magnitude(0, 40);
  ask.lambda_first = std::min(first, last);
  ask.lambda_last = std::max(first, last);
}

}  // namespace

EntryAsk passing(const Vector& point, const Vector& direction, Random& random) {
  const double before = random.dyadic(1, 8, 0);
  const double after = random.dyadic(0, 8, 0);
  EntryAsk ask;
  ask.from = plus(point, times(before, direction));
  ask.to = minus(point, times(after, direction));
  if (random.one_in(8)) set_unusual_range(ask, random);
  return ask;
}

EntryAsk starting_at(const Vector& point, const Vector& heading, Random& random) {
  EntryAsk ask;
  if (random.one_in(4)) {
    ask.lambda_first = random.dyadic(-4, 4, 2);
    ask.lambda_last = ask.lambda_first + random.dyadic(0, 4, 2);
  }
  ask.from = minus(point, times(ask.lambda_first, heading));
  ask.to = plus(ask.from, heading);
  return ask;
}

EntryAsk ending_at(const Vector& point, const Vector& heading, Random& random) {
  EntryAsk ask;
  if (random.one_in(4)) {
    ask.lambda_last = random.dyadic(-4, 4, 2);
    ask.lambda_first = ask.lambda_last - random.dyadic(0, 4, 2);
  }
  ask.from = minus(point, times(ask.lambda_last, heading));
  ask.to = plus(ask.from, heading);
  return ask;
}

Feature any_feature(const Landmarks& landmarks, Random& random) {
  if (random.one_in(8)) {
    const FacePoint crossing = at_a_crossing(landmarks, random);
    return {crossing.point, crossing.plane.normal};
  }
  const DetailedPiece piece = pick_piece(landmarks, random);
  switch (random.below(3)) {
    case 0: {
      const FacePoint face = on_a_face(piece, random);
      return {face.point, face.plane.normal};
    }
    case 1: {
      const EdgePoint edge = on_an_edge(piece, random);
      return {edge.point, edge.plane.normal};
    }
    default: {
      const FacePoint corner = at_a_corner(piece, random);
      return {corner.point, corner.plane.normal};
    }
  }
}

}  // namespace groundtruth::cases
