// Which face, where several meet (SPEC section 3).

#include <groundtruth/cases/scene_builders.hpp>

#include "corpus_parts.hpp"

namespace groundtruth::cases {
namespace {

Shape unit_box() { return box({0, 0, 0}, {1, 1, 1}); }
Shape two_boxes() { return union_of({unit_box(), box({1, 0, 0}, {2, 1, 1})}); }

std::vector<Case> seams() {
  const Scene abutting = ground(two_boxes());
  return {
      {"seam/along-the-top",
       abutting,
       EntryAsk{{1, 0.5, 2}, {1, 0.5, 0}},
       {"seam"},
       "The seam of two abutting boxes is hit from above: only the two tops are faces, never the walls "
       "between."},
      {"seam/inside-it",
       abutting,
       EntryAsk{{1, 0.5, 0.5}, {2, 0.5, 0.5}},
       {"seam", "inside", "normal-by-order"},
       "The start lies on the wall between two abutting boxes, which is interior of the union."},
      {"seam/beside-the-second",
       abutting,
       EntryAsk{{1.5, 0.5, 2}, {1.5, 0.5, 0}},
       {"seam"},
       "Both boxes have the one top plane, but above the second only the second's top stands there."},
      {"seam/across-it-from-the-rim",
       abutting,
       EntryAsk{{-1, 0.5, 1}, {3, 0.5, 1}},
       {"seam", "grazing"},
       "The segment slides in the top plane over both boxes: it enters at the first box's rim."},
      {"seam/two-half-spaces",
       ground(union_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, 0)})),
       EntryAsk{{0, 1, 1}, {0, 0, 0}},
       {"seam", "inside", "normal-by-order"},
       "x <= 0 and x >= 0 together are all of space: the plane between them is no face."},
      {"seam/gap-of-one-ulp",
       ground(union_of({unit_box(), box({0x1.0000000000001p+0, 0, 0}, {2, 1, 1})})),
       EntryAsk{{1, 0.5, 0.5}, {2, 0.5, 0.5}},
       {"seam", "one-ulp", "start-on-face"},
       "The boxes miss each other by one ulp: the start is on a face after all."},
      {"seam/overlap-of-one-ulp",
       ground(union_of({unit_box(), box({0x1.fffffffffffffp-1, 0, 0}, {2, 1, 1})})),
       EntryAsk{{1, 0.5, 0.5}, {2, 0.5, 0.5}},
       {"seam", "one-ulp", "inside"},
       "The boxes overlap by one ulp: what looks like a face lies inside."},
      {"seam/same-plane-twice",
       ground(union_of({half_space(0, 0, 1, 0), half_space(0, 0, 2, 0)})),
       EntryAsk{{0, 0, 1}, {0, 0, -1}},
       {"seam"},
       "One plane written twice, with normals of different length: either leaf may be named, with its own "
       "normal."},
      {"seam/hidden-plane",
       ground(union_of({half_space(0, 0, 1, 0), half_space(0, 0, 1, 1)})),
       EntryAsk{{0, 0, 2}, {0, 0, -2}},
       {"seam"},
       "The first leaf lies wholly inside the second: it is no face."},
  };
}

std::vector<Case> corners() {
  const Scene box_alone = ground(unit_box());
  return {
      {"corner/top-edge",
       box_alone,
       EntryAsk{{2, 0.5, 2}, {0, 0.5, 0}},
       {"edge"},
       "An edge is hit squarely: both of its faces are entered and admissible."},
      {"corner/vertex",
       box_alone,
       EntryAsk{{2, 2, 2}, {0, 0, 0}},
       {"corner"},
       "A vertex is hit: three faces are entered."},
      {"corner/vertex-beside-one-face",
       box_alone,
       EntryAsk{{2, 2, 1}, {0, 0, 1}},
       {"corner", "grazing"},
       "A vertex is hit by a segment in the top plane: the top is not entered, the two sides are."},
      {"corner/four-planes-through-a-point",
       ground(intersection_of({half_space(1, 0, 1, 0), half_space(-1, 0, 1, 0), half_space(0, 1, 1, 0),
                               half_space(0, -1, 1, 0)})),
       EntryAsk{{0, 0, 3}, {0, 0, -1}},
       {"corner"},
       "The tip of a pyramid: four faces, none before the others."},
      {"corner/re-entrant",
       ground(union_of({half_space(0, 0, 1, 0), half_space(1, 0, 0, 0)})),
       EntryAsk{{1, 0, 1}, {-1, 0, -1}},
       {"corner", "edge"},
       "Into the inner edge of an L: both faces are entered at once."},
      {"corner/two-boxes-meet-in-an-edge",
       ground(union_of({unit_box(), box({1, 0, 1}, {2, 1, 2})})),
       EntryAsk{{0, 0.5, 2}, {2, 0.5, 0}},
       {"corner", "edge", "sheet"},
       "Through the edge in which two boxes touch: the segment meets the solid in that point only."},
      {"corner/two-boxes-meet-in-a-vertex",
       ground(union_of({unit_box(), box({1, 1, 1}, {2, 2, 2})})),
       EntryAsk{{2, 0, 1}, {0, 2, 1}},
       {"corner", "sheet"},
       "Through the vertex in which two boxes touch."},
      {"corner/start-on-the-vertex",
       box_alone,
       EntryAsk{{1, 1, 1}, {2, 2, 2}},
       {"corner", "start-on-face"},
       "The start stands on a vertex and leaves: border at once, each of its three faces admissible."},
      {"corner/house-ridge",
       house(),
       EntryAsk{{0, 0, 10}, {0, 0, 1}},
       {"edge", "house-corners"},
       "The ridge of the source's house, from above."},
  };
}

std::vector<Case> grazing() {
  const Scene box_alone = ground(unit_box());
  return {
      {"grazing/top-plane",
       box_alone,
       EntryAsk{{-1, 0.5, 1}, {2, 0.5, 1}},
       {"grazing"},
       "Slides in the top plane: the solid is closed, so that it enters at the rim."},
      {"grazing/edge-alone",
       box_alone,
       EntryAsk{{-1, 0.5, 2}, {2, 0.5, -1}},
       {"grazing", "edge"},
       "Meets the box at x = 0, z = 1 and goes on inside."},
      {"grazing/outside-an-edge",
       box_alone,
       EntryAsk{{0, 0.5, 2}, {2, 0.5, 0}},
       {"grazing", "edge"},
       "Touches the edge x = z = 1 from outside, in one point."},
      {"grazing/outside-a-vertex",
       box_alone,
       EntryAsk{{2, 1, 0}, {0, 1, 2}},
       {"grazing", "corner"},
       "Touches the box along its rim y = 1 in a single point."},
      {"grazing/one-ulp-above",
       box_alone,
       EntryAsk{{-1, 0.5, 0x1.0000000000001p+0}, {2, 0.5, 0x1.0000000000001p+0}},
       {"grazing", "one-ulp"},
       "One ulp above the top plane: a miss."},
      {"grazing/parallel-inside-a-face",
       flat_ground(),
       EntryAsk{{0, 0, 0}, {5, 0, 0}},
       {"grazing", "start-on-face"},
       "Lies wholly in the plane: border at the first end."},
      {"grazing/leaves-from-a-face",
       flat_ground(),
       EntryAsk{{0, 0, 0}, {0, 0, 1}},
       {"start-on-face"},
       "Starts on the ground and leaves it: the ground is closed, so it is hit at once."},
      {"grazing/enters-from-a-face",
       flat_ground(),
       EntryAsk{{0, 0, 0}, {0, 0, -1}},
       {"start-on-face"},
       "Starts on the ground and goes into it: border, not inside."},
      {"grazing/starts-inside",
       flat_ground(),
       EntryAsk{{0, 0, -1}, {0, 0, 1}},
       {"inside"},
       "Starts inside: no face, no normal, no material."},
      {"grazing/one-ulp-inside",
       flat_ground(),
       EntryAsk{{0, 0, -0x1p-1074}, {0, 0, 1}},
       {"inside", "one-ulp"},
       "Starts inside by the least double there is."},
  };
}

std::vector<Case> sheets() {
  const Shape sheet = intersection_of({half_space(0, 0, 1, 0), half_space(0, 0, -1, 0)});
  const Shape needle = intersection_of({sheet, half_space(1, 0, 0, 0), half_space(-1, 0, 0, 0)});
  return {
      {"sheet/from-above",
       ground(sheet),
       EntryAsk{{0, 0, 1}, {0, 0, -1}},
       {"sheet"},
       "A solid without thickness: no face bounds it, the entered leaf is taken."},
      {"sheet/from-below",
       ground(sheet),
       EntryAsk{{0, 0, -1}, {0, 0, 1}},
       {"sheet"},
       "The same from below: the other leaf."},
      {"sheet/within-it",
       ground(sheet),
       EntryAsk{{0, 0, 0}, {1, 0, 0}},
       {"sheet", "start-on-face"},
       "Within the sheet: border, either leaf."},
      {"sheet/needle",
       ground(needle),
       EntryAsk{{-1, 0, 1}, {1, 0, -1}},
       {"sheet", "edge"},
       "A solid that is a line."},
      {"sheet/point",
       ground(intersection_of({needle, half_space(0, 1, 0, 0), half_space(0, -1, 0, 0)})),
       EntryAsk{{1, 1, 1}, {-1, -1, -1}},
       {"sheet", "corner"},
       "A solid that is a point."},
      {"sheet/glued-to-a-box",
       ground(union_of({unit_box(), intersection_of({sheet, half_space(-1, 0, 0, 0)})})),
       EntryAsk{{3, 0.5, 1}, {3, 0.5, -1}},
       {"sheet"},
       "A sheet that sticks out of a box: hit where it is alone."},
      {"sheet/one-ulp-thick",
       ground(intersection_of({half_space(0, 0, 1, 0x1p-1074), half_space(0, 0, -1, 0)})),
       EntryAsk{{0, 0, 1}, {0, 0, -1}},
       {"sheet", "one-ulp"},
       "As thick as doubles allow: its top is a face."},
      {"sheet/slit-of-no-width",
       ground(union_of({half_space(0, 0, 1, 0), half_space(0, 0, -1, 0)})),
       EntryAsk{{0, 0, 1}, {0, 0, -1}},
       {"seam", "inside"},
       "Two closed halves leave no slit: inside at once."},
  };
}

}  // namespace

std::vector<Case> corpus_of_faces() {
  std::vector<Case> all = seams();
  for (auto chapter : {corners(), grazing(), sheets()}) {
    all.insert(all.end(), chapter.begin(), chapter.end());
  }
  return all;
}

}  // namespace groundtruth::cases
