#include <groundtruth/fast/exact_stage/strut.hpp>

#include <limits>

#include <groundtruth/fast/exact_stage/first_point.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

class Strut {
 public:
  Strut(const StepAsk& ask, const WorldFromWheel& world_from_wheel, const PlaceInWheel& place)
      : numbers_{place.roots}, denominator_(place.denominator * world_from_wheel.norm_squared()) {
    const Dyadic z_min = place.denominator * ask.wheel.z_min;
    const Dyadic length = place.denominator * (Dyadic(ask.wheel.z_max) - ask.wheel.z_min);
    start_ = world_from_wheel.to_world<Surd>({place.x, place.y, Surd{z_min, {}, {}}});
    direction_ = world_from_wheel.to_world<Dyadic>({Dyadic(), Dyadic(), length});
    for (std::size_t axis = 0; axis < 3; ++axis)
      start_[axis].rational = start_[axis].rational + denominator_ * ask.frame.position_in_world[axis];
  }

  const SurdNumbers& numbers() const { return numbers_; }

  Line<SurdNumbers> line(const HalfSpace& leaf) const {
    const Normal<Dyadic> normal = dyadic_normal(leaf);
    Surd value = start_[0] * normal[0] + start_[1] * normal[1] + start_[2] * normal[2];
    value.rational = value.rational - denominator_ * leaf.offset;
    const Dyadic slope = dot(normal, direction_);
    return {value, slope, slope.sign()};
  }

  Lines<SurdNumbers> lines(const ExpressionView& expression) const {
    Lines<SurdNumbers> lines;
    for (const HalfSpace& leaf : expression.leaves) lines.push_back(line(leaf));
    return lines;
  }

  // In doubles.
  RangeEnds ends() const {
    std::array<Surd, 3> last = start_;
    for (std::size_t axis = 0; axis < 3; ++axis) last[axis].rational = last[axis].rational + direction_[axis];
    const auto first_end = nearest_doubles({start_, denominator_, numbers_.roots}, "");
    const auto last_end = nearest_doubles({last, denominator_, numbers_.roots}, "");
    if (first_end.index() != 0 || last_end.index() != 0)
      return {{}, {}, std::numeric_limits<double>::infinity()};
    RangeEnds ends{std::get<Vector>(first_end), std::get<Vector>(last_end), 0};
    ends.coordinate_error = 0x1p-53 * ends.greatest_coordinate() + 0x1p-1000;
    return ends;
  }

  // Requires that the line enters.
  SurdVector point_on(const Line<SurdNumbers>& line) const {
    const Dyadic steepness = -line.slope;
    SurdVector point{{}, denominator_ * steepness, numbers_.roots};
    for (std::size_t axis = 0; axis < 3; ++axis)
      point.numerators[axis] = start_[axis] * steepness + line.value * direction_[axis];
    return point;
  }

 private:
  const SurdNumbers numbers_;
  const Dyadic denominator_;
  std::array<Surd, 3> start_;
  Normal<Dyadic> direction_;
};

std::optional<MaterialIndex> material_at(const Scene& scene, Leaf leaf, const Strut& strut,
                                         const Line<SurdNumbers>& place) {
  std::optional<MaterialIndex> material;
  for (auto rule_place = scene.rule_of(static_cast<std::uint32_t>(leaf)); rule_place;
       rule_place = scene.rules()[*rule_place].outer_rule) {
    const MaterialRule& rule = scene.rules()[*rule_place];
    if (rule.region) {
      const Expression& expression = scene.regions()[*rule.region];
      const ExpressionView region{expression.nodes, expression.leaves, {}};
      const Lines<SurdNumbers> lines = strut.lines(region);
      if (!contains(strut.numbers(), region, lines, &place)) continue;
    }
    material = rule.material;
  }
  return material;
}

}  // namespace

Touch touch(const Scene& scene, Ground& ground, const StepAsk& ask, const WorldFromWheel& world_from_wheel,
            const PlaceInWheel& place) {
  const Strut strut(ask, world_from_wheel, place);
  const ExpressionView solid = ground.along(strut.ends());
  const Lines<SurdNumbers> lines = strut.lines(solid);
  const auto found = find_first_point(strut.numbers(), solid, lines, Dyadic(1.0));
  if (!found || found->is_at_end) return NoContact{};
  if (!found->crossed || !found->leaf) return StepFailure::wheel_broken;
  const HalfSpace& leaf = solid.leaves[*found->leaf];
  if (!is_upright(world_from_wheel.to_wheel(dyadic_normal(leaf)), ask.wheel.min_uprightness))
    return StepFailure::surface_too_steep;
  const Leaf number = solid.numbers.empty() ? *found->leaf : solid.numbers[*found->leaf];
  const Line<SurdNumbers>& crossed = lines[*found->crossed];
  const auto surface =
      surface_of(scene, number, leaf.normal, material_at(scene, number, strut, crossed), ask.wheel.tyre);
  if (const auto* refusal = std::get_if<Refusal>(&surface)) return *refusal;
  return Landing{std::get<Surface>(surface), strut.point_on(crossed)};
}

}  // namespace groundtruth::fast::exact_stage
