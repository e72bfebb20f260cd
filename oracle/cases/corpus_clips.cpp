// Which force a pebble can bear (SPEC section 4).

#include "corpus_parts.hpp"

namespace groundtruth::cases {
namespace {

const Vector flat{0, 0, -1};
const Vector slope{0.75, 0, -1};  // 3-4-5

Case clip(std::string id, ClipAsk ask, Flags flags, std::string note) {
  return {"clip/" + std::move(id), {{}, {Nothing{}}}, std::move(ask), std::move(flags), std::move(note)};
}

}  // namespace

std::vector<Case> corpus_of_clips() {
  return {
      clip("inside", {{1, 1, -10}, flat, 0.5, 100}, {"border"}, "Well inside: sticks, unchanged."),
      clip("on-the-circle", {{3, 4, -10}, flat, 0.5, 100}, {"border"},
           "Exactly on the circle: the border belongs to stick."),
      clip("one-ulp-outside-the-circle", {{3, 0x1.0000000000001p+2, -10}, flat, 0.5, 100},
           {"border", "one-ulp"}, "One ulp outside the circle: slips."),
      clip("on-the-band", {{2, 1, -10}, flat, 0.5, 2}, {"border", "brake"},
           "Exactly on the brake band: sticks."),
      clip("one-ulp-outside-the-band", {{0x1.0000000000001p+1, 1, -10}, flat, 0.5, 2},
           {"border", "brake", "one-ulp"}, "One ulp outside the band: rolls."),
      clip("case-1", {{-8, 2, -10}, flat, 0.5, 3}, {"brake"},
           "Outside the band, within the circle's height there: F'_y stays."),
      clip("case-2-corner", {{8, 6, -10}, flat, 0.5, 3}, {"band-corner"},
           "Goes to the corner of band and circle, (3, 4)."),
      clip("case-2-meets-case-1", {{6, 4, -10}, flat, 0.5, 3}, {"band-corner"},
           "|F'_y| = s exactly: cases 1 and 2 agree."),
      clip("case-2-meets-case-3", {{6, 8, -10}, flat, 0.5, 3}, {"band-corner"},
           "B |F'_y| = |F'_x| s exactly: cases 2 and 3 agree."),
      clip("case-3", {{1, 30, -10}, flat, 0.5, 3}, {"friction"}, "Sideways: scaled down to the circle."),
      clip("brake-equals-friction", {{8, 1, -10}, flat, 0.5, 5}, {"band-corner"},
           "B = mu N: the band touches the circle, s = 0."),
      clip("no-brake", {{8, 1, -10}, flat, 0.5, 0}, {"brake"}, "B = 0: rolls freely, keeps the side force."),
      clip("no-brake-on-the-axis", {{0, 1, -10}, flat, 0.5, 0}, {"brake", "border"},
           "B = 0 and F'_x = 0: on the border, sticks."),
      clip("no-friction", {{3, 4, -10}, flat, 0, 100}, {"friction"}, "mu = 0: nothing is left sideways."),
      clip("no-force", {{0, 0, 0}, flat, 0.5, 1}, {"border"}, "No force at all: sticks."),
      clip("no-normal-force", {{3, 4, 0}, flat, 0.5, 100}, {"border"}, "N = 0: the border is a point."),
      clip("pulled-away", {{3, 4, -2}, flat, 0.5, 100}, {"signed-normal-force", "tensile"},
           "F'_z < 0 and slip: with mu F'_z the friction would flip."),
      clip("slope-band", {{2, 0, -10}, slope, 1, 4}, {"band-test-wheel-x", "surface-frame-sign"},
           "On a slope the band is along F'_x, not along the wheel's x."),
      clip("slope-sticks", {{-7.5, 0, -10}, slope, 0.5, 8}, {"surface-frame-sign", "border"},
           "A slope of 3-4-5 in x."),
      clip("slope-sideways", {{1, -8, -10}, {0, 0.75, -1}, 0.25, 8}, {"surface-frame-sign"},
           "A slope of 3-4-5 in y."),
      clip("slope-both-ways", {{1, 2, -3}, {1, 2, -2}, 0.125, 0.25},
           {"surface-frame-sign", "band-test-wheel-x"},
           "A slope in x and y: both signs of the surface frame matter."),
      clip("long-normal", {{3, 4, -10}, {0, 0, -1e200}, 0.25, 100}, {"big-world"},
           "A normal whose square overflows."),
      clip("short-normal", {{3, 4, -10}, {0, 0, -1e-200}, 0.25, 100}, {"one-ulp"},
           "A normal whose square underflows."),
      clip("upright-by-the-threshold", {{3, 4, -10}, {8, 0, -4}, 0.25, 100, 0.5}, {"steep"},
           "Exactly as steep as may be: upright."),
      clip("too-steep-by-one-ulp", {{3, 4, -10}, {0x1.0000000000001p+3, 0, -4}, 0.25, 100, 0.5},
           {"steep", "one-ulp"}, "Steeper by one ulp: too steep."),
      clip("overhanging", {{3, 4, -10}, {0, 0, 1}, 0.25, 100}, {"steep"}, "The normal points the wrong way."),
      clip("wall", {{0, 0, 0}, {1, 0, 0}, 0.25, 100}, {"steep"},
           "A wall is too steep whatever the force, even none."),
      clip("zero-normal", {{1, 0, -1}, {0, 0, 0}, 0.25, 100}, {"steep"}, "No normal at all: too steep."),
      clip("steep-in-y-only", {{1, 1, -8}, {0, 20, -1}, 0.25, 100}, {"steep"},
           "Steepness counts y as well as x."),
  };
}

}  // namespace groundtruth::cases
