#include <groundtruth/exact/solid/entry.hpp>

#include <cmath>
#include <limits>

#include <groundtruth/exact/arithmetic/rounding.hpp>
#include <groundtruth/exact/solid/faces.hpp>
#include <groundtruth/exact/solid/recursion.hpp>
#include <groundtruth/exact/solid/sieve.hpp>

namespace groundtruth::exact {
namespace {

std::pair<double, double> bounds(const Rational& value) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nearest = nearest_double(value);
  if (std::isfinite(nearest) && Rational(nearest) == value) return {nearest, nearest};
  return {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)};
}

std::pair<double, double> bounds(const RootSum& value) {
  constexpr unsigned bits = 128;
  const auto [lower, upper] = value.enclosure(bits);
  return {bounds(lower).first, bounds(upper).second};
}

template <typename Number>
PointEnclosure enclosure(const std::array<Number, 3>& point) {
  return {bounds(point[0]), bounds(point[1]), bounds(point[2])};
}

template <typename Number>
std::array<Number, 3> point_at(const Segment<Number>& segment, const Number& lambda) {
  const auto coordinate = [&](std::size_t axis) {
    const Rational& direction = segment.direction[static_cast<int>(axis)];
    return Number(segment.origin[axis] + Number(lambda * direction));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

template <typename Number>
Number delta(const RationalVector& normal, const Rational& offset, const std::array<Number, 3>& x) {
  const Number along_x = x[0] * normal.x();
  const Number along_y = x[1] * normal.y();
  const Number along_z = x[2] * normal.z();
  return Number(Number(along_x + along_y) + Number(along_z - Number(offset)));
}

// What may decide along a segment: the sieved expression, its leaves being places in the vectors beside it.
template <typename Number>
struct Deciders {
  Expression expression;
  std::vector<Leaf> leaves;
  std::vector<RationalVector> normals;
  std::vector<Course<Number>> courses;
};

template <typename Number>
Deciders<Number> deciders(const Solid& solid, const Segment<Number>& segment) {
  const auto first = point_at(segment, Number(segment.first));
  const auto last = point_at(segment, Number(segment.last));
  Deciders<Number> found;
  found.expression = sieve(solid, enclosure(first), enclosure(last));
  for (Node& node : found.expression) {
    if (node.operation != Operation::leaf) continue;
    const HalfSpace& half_space = solid.half_spaces[node.leaf];
    const RationalVector normal = to_rational(half_space.normal);
    found.leaves.push_back(node.leaf);
    found.normals.push_back(normal);
    found.courses.push_back(
        {delta(normal, Rational(half_space.offset), segment.origin), normal * segment.direction});
    node.leaf = found.leaves.size() - 1;
  }
  return found;
}

// How the segment comes to the point of entry: only by moving does it need to enter the half-spaces there.
enum class Arrival { by_starting, by_moving };

template <typename Number>
LocalFaces faces_at(const Deciders<Number>& deciders, const Number& lambda, Arrival arrival) {
  const std::size_t count = deciders.leaves.size();
  std::vector<int> sides(count);
  std::vector<LocalLeaf> through;
  std::vector<std::size_t> place_of(count);
  for (std::size_t i = 0; i < count; ++i) {
    sides[i] = sign(deciders.courses[i].at(lambda));
    const bool goes_through = sides[i] == 0 && !is_zero(deciders.normals[i]);
    if (!goes_through) continue;
    place_of[i] = through.size();
    const bool counts = arrival == Arrival::by_starting || sign(deciders.courses[i].slope) < 0;
    through.push_back({deciders.leaves[i], deciders.normals[i], counts});
  }
  Expression cone = reduced(deciders.expression, [&](std::size_t i) {
    if (sides[i] == 0) return is_zero(deciders.normals[i]) ? Truth::yes : Truth::unknown;
    return sides[i] < 0 ? Truth::yes : Truth::no;
  });
  for (Node& node : cone) {
    if (node.operation == Operation::leaf) node.leaf = place_of[node.leaf];
  }
  return faces_at(cone, through);
}

// Whether a point lies in the solid.
template <typename Number>
bool contains(const Solid& solid, const std::array<Number, 3>& point) {
  const auto truth = [&](Leaf leaf) {
    const HalfSpace& half_space = solid.half_spaces[leaf];
    const Number value = delta(to_rational(half_space.normal), Rational(half_space.offset), point);
    return sign(value) <= 0 ? Truth::yes : Truth::no;
  };
  return evaluate(solid.expression, 0, truth) == Truth::yes;
}

}  // namespace

template <typename Number>
std::optional<Entry<Number>> find_entry(const Solid& solid, const Segment<Number>& segment) {
  const Deciders<Number> along = deciders(solid, segment);
  const Number first(segment.first);
  const auto lambda = Recursion<Number>(along.expression, along.courses, Number(segment.last)).entry(first);
  if (!lambda) return std::nullopt;
  const Arrival arrival = less(first, *lambda) ? Arrival::by_moving : Arrival::by_starting;
  LocalFaces faces = faces_at(along, *lambda, arrival);
  return Entry<Number>{*lambda, point_at(segment, *lambda), faces.interior, std::move(faces.admissible)};
}

template <typename Number>
std::optional<MaterialIndex> material_at(const Ground& ground, Leaf leaf,
                                         const std::array<Number, 3>& point) {
  for (const Layer& layer : ground.layers) {
    const bool covers = layer.first_leaf <= leaf && leaf < layer.end_leaf;
    if (covers && (!layer.region || contains(*layer.region, point))) return layer.material;
  }
  return std::nullopt;
}

template std::optional<Entry<Rational>> find_entry(const Solid&, const Segment<Rational>&);
template std::optional<Entry<RootSum>> find_entry(const Solid&, const Segment<RootSum>&);
template std::optional<MaterialIndex> material_at(const Ground&, Leaf, const std::array<Rational, 3>&);
template std::optional<MaterialIndex> material_at(const Ground&, Leaf, const std::array<RootSum, 3>&);

}  // namespace groundtruth::exact
