#include <groundtruth/explanation/explanation.hpp>

namespace groundtruth::explanation {
namespace {

// More than these are neither read nor searched with pleasure.
constexpr std::size_t most_in_play = 32;

// Of a leaf whose plane stays more than `reach` metres away from the segment.
Truth truth_along(const Plane& plane, const Segment& segment, const std::optional<double>& reach) {
  if (!plane.is_a_plane()) return plane.offset >= 0 ? Truth::yes : Truth::no;
  if (!reach) return Truth::unknown;
  const Rational one = plane.height(segment.at(segment.first));
  const Rational other = plane.height(segment.at(segment.last));
  const Rational margin = Rational(*reach) * Rational(*reach) * dot(plane.normal, plane.normal);
  const bool is_far = one * one > margin && other * other > margin;
  if (!is_far || one.sign() != other.sign()) return Truth::unknown;
  return one < 0 ? Truth::yes : Truth::no;
}

// What is in play shrinks with the reach.
void choose_what_is_in_play(const Scene& scene, EntryFacts& facts) {
  const auto truth = [&](const Plane& plane) { return truth_along(plane, facts.segment, facts.reach); };
  facts.in_play = solid_where(scene.shape, truth);
  double reach = 1e6;
  while (facts.in_play.planes.size() > most_in_play && reach > 1e-9) {
    facts.reach = reach;
    facts.in_play = solid_where(scene.shape, truth);
    reach /= 4;
  }
}

std::vector<Stop> stops_of(const Solid& solid, const Segment& segment) {
  const std::vector<Rational> breakpoints = breakpoints_of(solid, segment);
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < breakpoints.size(); ++i) {
    const Rational& here = breakpoints[i];
    stops.push_back({here, here, lit(solid, truth_at(solid, segment, here))});
    if (i + 1 == breakpoints.size()) break;
    const Rational& next = breakpoints[i + 1];
    stops.push_back({here, next, lit(solid, truth_at(solid, segment, (here + next) / 2))});
  }
  return stops;
}

}  // namespace

EntryFacts facts_of(const Scene& scene, const Segment& segment) {
  EntryFacts facts;
  facts.segment = segment;
  facts.leaves_in_all = planes_of(scene.shape).size();
  choose_what_is_in_play(scene, facts);
  facts.stops = stops_of(facts.in_play, segment);
  facts.decision = decision_on(facts.in_play, segment);
  const Rational reach = facts.reach ? Rational(*facts.reach) : Rational(1e300);
  facts.search = nearest_flips(facts.in_play, segment, reach * reach);
  return facts;
}

}  // namespace groundtruth::explanation
