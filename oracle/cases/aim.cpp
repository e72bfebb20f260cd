#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/corners.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

bool lies_on(const Corner& corner, std::size_t plane) {
  return std::find(corner.planes.begin(), corner.planes.end(), plane) != corner.planes.end();
}

// One of the corner's planes that belong to the piece itself.
std::size_t own_plane(const DetailedPiece& piece, const Corner& corner, Random& random) {
  const std::size_t plane = corner.planes[random.below(3)];
  return plane < piece.own_planes ? plane : corner.planes[0];
}

// i / 2^k for a random i in [0, 2^k] and small k.
double short_weight(Random& random) {
  const int bits = static_cast<int>(random.between(1, 4));
  return random.dyadic(0, 1, bits);
}

}  // namespace

DetailedPiece pick_piece(const Landmarks& landmarks, Random& random) {
  constexpr std::size_t favoured = 4;
  const std::size_t count = landmarks.pieces.size();
  const std::size_t among = random.one_in(4) ? std::min(favoured, count) : count;
  return detail(landmarks, random.below(among));
}

FacePoint on_a_face(const DetailedPiece& piece, Random& random) {
  const Corner& corner = random.pick(piece.corners);
  const std::size_t plane = own_plane(piece, corner, random);
  std::vector<Vector> rim;
  for (const Corner& other : piece.corners) {
    if (lies_on(other, plane)) rim.push_back(other.point);
  }
  const Vector& b = random.pick(rim);
  const Vector& c = random.pick(rim);
  const double to_b = short_weight(random);
  const double to_c = short_weight(random) * (1 - to_b);
  const Vector point =
      plus(corner.point, plus(times(to_b, minus(b, corner.point)), times(to_c, minus(c, corner.point))));
  return {point, piece.planes[plane]};
}

EdgePoint on_an_edge(const DetailedPiece& piece, Random& random) {
  const Corner& corner = random.pick(piece.corners);
  const std::size_t plane = own_plane(piece, corner, random);
  std::vector<Vector> ends;
  for (const Corner& other : piece.corners) {
    if (other.point == corner.point || !lies_on(other, plane)) continue;
    const auto shared =
        std::count_if(other.planes.begin(), other.planes.end(),
                      [&](std::size_t shared_plane) { return lies_on(corner, shared_plane); });
    if (shared >= 2) ends.push_back(other.point);
  }
  const HalfSpace& face = piece.planes[plane];
  if (ends.empty()) return {corner.point, direction_in_plane(face.normal, random), face};
  const Vector along = minus(random.pick(ends), corner.point);
  return {plus(corner.point, times(short_weight(random), along)), along, face};
}

FacePoint at_a_corner(const DetailedPiece& piece, Random& random) {
  const Corner& corner = random.pick(piece.corners);
  return {corner.point, piece.planes[own_plane(piece, corner, random)]};
}

Vector in_the_piece(const DetailedPiece& piece, Random& random) {
  Vector sum{};
  for (int i = 0; i < 8; ++i) sum = plus(sum, times(0.125, random.pick(piece.corners).point));
  return sum;
}

FacePoint foothold(const Landmarks& landmarks, Random& random) {
  FacePoint best;
  double steepest = -2;
  for (int tries = 0; tries < 6; ++tries) {
    const FacePoint next = on_a_face(pick_piece(landmarks, random), random);
    const double uprightness = next.plane.normal[2] / length(next.plane.normal);
    if (uprightness > steepest) {
      best = next;
      steepest = uprightness;
    }
    if (uprightness > 0.3) break;
  }
  return best;
}

FacePoint at_a_crossing(const Landmarks& landmarks, Random& random) {
  constexpr std::size_t neighbourhood = 4;
  const std::size_t first = random.below(landmarks.pieces.size());
  const std::size_t last = std::min(first + neighbourhood, landmarks.pieces.size());
  const auto any_plane = [&] {
    const std::size_t piece = first + random.below(last - first);
    return random.pick(landmarks.pieces[piece]);
  };
  const HalfSpace a = any_plane();
  const HalfSpace b = any_plane();
  const HalfSpace c = any_plane();
  const std::optional<Vector> point = meeting_point(a, b, c);
  if (point) return {*point, a};
  return at_a_corner(detail(landmarks, first), random);
}

Vector in_bounds(const Landmarks& landmarks, Random& random) {
  Vector point{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double margin = 0.25 * (landmarks.high[i] - landmarks.low[i]);
    point[i] = random.uniform(landmarks.low[i] - margin, landmarks.high[i] + margin);
  }
  return point;
}

Vector lattice_point(const Landmarks& landmarks, int fraction_bits, Random& random) {
  Vector point{};
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = random.dyadic(static_cast<std::int64_t>(landmarks.low[i]),
                             static_cast<std::int64_t>(landmarks.high[i]), fraction_bits);
  }
  return point;
}

Vector short_direction(Random& random) {
  Vector direction{};
  if (random.one_in(4)) {
    direction[random.below(3)] = random.sign();
  } else {
    while (direction == Vector{}) {
      direction = {random.dyadic(-8, 8, 0), random.dyadic(-8, 8, 0), random.dyadic(-8, 8, 0)};
    }
  }
  return times(std::ldexp(1.0, static_cast<int>(random.between(-3, 3))), direction);
}

Vector outward_direction(const Vector& normal, Random& random) {
  const Vector direction = short_direction(random);
  return dot(normal, direction) < 0 ? times(-1, direction) : direction;
}

Vector direction_in_plane(const Vector& normal, Random& random) {
  const Vector direction = cross(normal, short_direction(random));
  if (direction != Vector{}) return direction;
  const Vector least_aligned = std::abs(normal[0]) < std::abs(normal[1]) ? Vector{1, 0, 0} : Vector{0, 1, 0};
  return cross(normal, least_aligned);
}

}  // namespace groundtruth::cases
