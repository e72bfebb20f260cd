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
       {"seam", "normal-by-order"},
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
       {"seam", "normal-by-order"},
       "The first leaf lies wholly inside the second: it is no face."},
  };
}

}  // namespace

std::vector<Case> corpus_of_faces() { return seams(); }

}  // namespace groundtruth::cases
