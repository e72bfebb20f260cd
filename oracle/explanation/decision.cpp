#include <groundtruth/explanation/decision.hpp>

#include <algorithm>
#include <set>

namespace groundtruth::explanation {
namespace {

constexpr std::size_t most_tries = 600;

// A change to one plane's offset at which something along the segment coincides.
struct Candidate {
  std::size_t plane = 0;
  int side = 1;
  Rational change;
  Rational beyond;  // a change between this one and the next
  Rational metres_squared;
};

class FlipSearch {
 public:
  FlipSearch(const Solid& solid, const Segment& segment, const Rational& reach_squared)
      : solid_(solid), segment_(segment), reach_squared_(reach_squared), now_(decision_on(solid, segment)) {}

  Search run() {
    for (std::size_t plane = 0; plane < solid_.planes.size(); ++plane) {
      if (!solid_.planes[plane].is_a_plane()) continue;
      add_candidates(plane, +1);
      add_candidates(plane, -1);
    }
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return a.metres_squared < b.metres_squared;
    });
    for (const Candidate& candidate : candidates_) {
      if (wants_nothing()) break;
      if (search_.tried >= most_tries) {
        search_.is_complete = false;
        break;
      }
      try_change(candidate, candidate.change, true);
      try_change(candidate, candidate.beyond, false);
    }
    return std::move(search_);
  }

 private:
  // On one side of where the plane is now. Nothing coincides between one candidate and the next.
  void add_candidates(std::size_t place, int side) {
    const Plane& plane = solid_.planes[place];
    std::set<Rational> changes{Rational(0)};
    for (const Rational& lambda : breakpoints_of(solid_, segment_)) {
      const Rational change = plane.height(segment_.at(lambda));
      if (change.sign() == side) changes.insert(change * side);
    }
    const Rational squared = dot(plane.normal, plane.normal);
    for (auto change = changes.begin(); change != changes.end(); ++change) {
      const auto next = std::next(change);
      const Rational beyond = next == changes.end() ? *change + 1 : Rational((*change + *next) / 2);
      const Rational metres_squared = *change * *change / squared;
      if (metres_squared > reach_squared_) break;
      candidates_.push_back({place, side, side * *change, side * beyond, metres_squared});
    }
  }

  bool wants_nothing() const {
    return search_.flips.size() == 2 || (!now_.lambda && has(Flips::hit_or_miss));
  }
  bool has(Flips what) const {
    return std::any_of(search_.flips.begin(), search_.flips.end(),
                       [&](const Flip& flip) { return flip.what == what; });
  }

  void try_change(const Candidate& candidate, const Rational& change, bool is_reached) {
    ++search_.tried;
    Solid moved = solid_;
    moved.planes[candidate.plane].offset += change;
    const Decision then = decision_on(moved, segment_);
    const bool flips_hit = then.lambda.has_value() != now_.lambda.has_value();
    const Flips what = flips_hit ? Flips::hit_or_miss : Flips::face;
    if ((!flips_hit && then.canonical == now_.canonical) || has(what)) return;
    search_.flips.push_back({what, candidate.plane, candidate.change, candidate.side, is_reached,
                             candidate.metres_squared, then});
  }

  const Solid& solid_;
  const Segment& segment_;
  const Rational& reach_squared_;
  Decision now_;
  std::vector<Candidate> candidates_;
  Search search_;
};

}  // namespace

std::vector<Rational> breakpoints_of(const Solid& solid, const Segment& segment) {
  std::set<Rational> lambdas{segment.first, segment.last};
  for (const Plane& plane : solid.planes) {
    const Rational slope = dot(plane.normal, segment.direction);
    if (slope == 0) continue;
    const Rational lambda = -plane.height(segment.from) / slope;
    if (segment.first < lambda && lambda < segment.last) lambdas.insert(lambda);
  }
  return {lambdas.begin(), lambdas.end()};
}

std::vector<bool> truth_at(const Solid& solid, const Segment& segment, const Rational& lambda) {
  const RationalVector point = segment.at(lambda);
  std::vector<bool> truth;
  for (const Plane& plane : solid.planes) truth.push_back(plane.height(point) <= 0);
  return truth;
}

Decision decision_on(const Solid& solid, const Segment& segment) {
  Decision decision;
  for (const Rational& lambda : breakpoints_of(solid, segment)) {
    const std::vector<bool> truth = truth_at(solid, segment, lambda);
    const auto of_plane = [&](std::size_t plane) { return truth[plane] ? Truth::yes : Truth::no; };
    if (evaluate(solid, of_plane) != Truth::yes) continue;
    decision.lambda = lambda;
    decision.meeting = meeting_at(solid, {segment.at(lambda), segment.direction, lambda == segment.first});
    for (const TiedFace& face : decision.meeting.faces) {
      if (!decision.meeting.is_admissible(face)) continue;
      decision.canonical = face.plane;
      break;
    }
    break;
  }
  return decision;
}

Search nearest_flips(const Solid& solid, const Segment& segment, const Rational& reach_squared) {
  return FlipSearch(solid, segment, reach_squared).run();
}

}  // namespace groundtruth::explanation
