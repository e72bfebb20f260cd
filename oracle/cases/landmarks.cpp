#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

#include <groundtruth/cases/corners.hpp>
#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/cases/seams.hpp>

namespace groundtruth::cases {
namespace {

constexpr std::size_t most_planes = 12;  // that are combined to corners
constexpr double farthest = 1e9;         // m
constexpr std::size_t enough_corners = 4;

// Adds the plane, with its normal's largest component scaled by a power of two into [1, 2) so that products
// of normals do not leave the range of doubles.
void add_plane(const HalfSpace& half_space, Piece& piece) {
  const Vector& n = half_space.normal;
  const double largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
  if (largest == 0) return;
  const int down = -std::ilogb(largest);
  const Vector normal{std::scalbn(n[0], down), std::scalbn(n[1], down), std::scalbn(n[2], down)};
  const double offset = std::scalbn(half_space.offset, down);
  piece.push_back(std::isfinite(offset) ? HalfSpace{normal, offset} : half_space);
}

// Adds the half-spaces that are operands of the intersection at hand to `piece`, and to `pieces` whatever
// is something else.
void collect(const Shape& shape, Piece& piece, std::vector<Piece>& pieces);

void collect_apart(const Shape& shape, std::vector<Piece>& pieces) {
  Piece piece;
  collect(shape, piece, pieces);
  if (!piece.empty()) pieces.push_back(std::move(piece));
}

void collect(const Shape& shape, Piece& piece, std::vector<Piece>& pieces) {
  std::visit(
      [&](const auto& expression) {
        using Expression = std::decay_t<decltype(expression)>;
        if constexpr (std::is_same_v<Expression, HalfSpace>) {
          add_plane(expression, piece);
        } else if constexpr (std::is_same_v<Expression, Intersection>) {
          for (const Shape& operand : expression.operands) collect(operand, piece, pieces);
        } else if constexpr (std::is_same_v<Expression, Union>) {
          for (const Shape& operand : expression.operands) collect_apart(operand, pieces);
        } else if constexpr (std::is_same_v<Expression, Covered>) {
          collect(*expression.over, piece, pieces);
        } else if constexpr (std::is_same_v<Expression, Painted>) {
          collect_apart(*expression.where, pieces);
          collect(*expression.over, piece, pieces);
        }
      },
      shape.expression);
}

Piece first_planes(const Piece& piece) {
  return {piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(std::min(piece.size(), most_planes))};
}

void widen(PieceBounds& bounds, const Vector& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    bounds.low[i] = std::min(bounds.low[i], point[i]);
    bounds.high[i] = std::max(bounds.high[i], point[i]);
  }
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// All of space for a piece that has too few corners to be bounded.
PieceBounds bounds_of(const Piece& piece) {
  const Piece planes = first_planes(piece);
  const std::vector<Corner> corners = corners_of(planes, planes.size(), Keep::feasible);
  if (corners.size() < enough_corners) {
    return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  }
  PieceBounds bounds{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Corner& corner : corners) widen(bounds, corner.point);
  return bounds;
}

bool is_near(const PieceBounds& bounds) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (bounds.low[i] < -farthest || bounds.high[i] > farthest) return false;
  }
  return true;
}

void set_bounds(Landmarks& landmarks, const std::vector<PieceBounds>& bounds) {
  PieceBounds all{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const PieceBounds& one : bounds) {
    if (!is_near(one)) continue;
    widen(all, one.low);
    widen(all, one.high);
  }
  if (all.low[0] > all.high[0]) all = {{-8, -8, -8}, {8, 8, 8}};
  for (std::size_t i = 0; i < 3; ++i) {
    landmarks.low[i] = std::floor(all.low[i]) - 1;
    landmarks.high[i] = std::ceil(all.high[i]) + 1;
  }
}

}  // namespace

Landmarks survey(const Scene& scene) {
  Landmarks landmarks;
  landmarks.materials = scene.materials;
  collect_apart(scene.shape, landmarks.pieces);
  // A scene without planes has no landmarks; a plane through the origin is as good a target as any.
  if (landmarks.pieces.empty()) landmarks.pieces.push_back({HalfSpace{{0, 0, 1}, 0}});
  std::vector<PieceBounds> bounds;
  bounds.reserve(landmarks.pieces.size());
  for (const Piece& piece : landmarks.pieces) bounds.push_back(bounds_of(piece));
  set_bounds(landmarks, bounds);
  landmarks.seams = find_seams(landmarks.pieces, bounds);
  return landmarks;
}

DetailedPiece detail(const Landmarks& landmarks, std::size_t piece) {
  DetailedPiece result;
  result.planes = first_planes(landmarks.pieces[piece]);
  result.own_planes = result.planes.size();
  result.corners = corners_of(result.planes, result.own_planes, Keep::feasible);
  if (result.corners.size() >= enough_corners) return result;

  const Vector& low = landmarks.low;
  const Vector& high = landmarks.high;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector axis{};
    axis[i] = 1;
    result.planes.push_back({axis, high[i]});
    axis[i] = -1;
    result.planes.push_back({axis, 0 - low[i]});
  }
  result.corners = corners_of(result.planes, result.own_planes, Keep::feasible);
  if (result.corners.empty()) result.corners = corners_of(result.planes, result.own_planes, Keep::all);
  if (result.corners.empty()) result.corners.push_back({low, {0, 0, 0}});
  return result;
}

}  // namespace groundtruth::cases
