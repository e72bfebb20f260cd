// Expressions (SPEC section 3).

#include "corpus_parts.hpp"

namespace groundtruth::cases {
namespace {

const EntryAsk down{{0, 0, 1}, {0, 0, -1}};

Shape nested(unsigned depth) {
  Shape shape = half_space(0, 0, 1, 0);
  for (unsigned i = 0; i < depth; ++i) {
    const double side = 1 + i;
    shape = i % 2 == 0 ? intersection_of({half_space(0, 0, 1, side), std::move(shape)})
                       : union_of({half_space(0, 0, 1, -side), std::move(shape)});
  }
  return shape;
}

// Slabs a metre thick along x.
Shape comb(const std::vector<double>& starts) {
  std::vector<Shape> teeth;
  for (const double start : starts) teeth.push_back(box({start, -1, -1}, {start + 1, 1, 1}));
  return union_of(std::move(teeth));
}

}  // namespace

std::vector<Case> corpus_of_expressions() {
  const Shape gap = intersection_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, -1)});
  const Shape steps = intersection_of({union_of({half_space(1, 0, 0, 0), half_space(-1, 0, 0, -2)}),
                                       union_of({half_space(1, 0, 0, -1), half_space(-1, 0, 0, -3)})});
  return {
      {"expression/x-below-0-and-above-1",
       ground(gap),
       EntryAsk{{-1, 0, 0}, {2, 0, 0}},
       {"expression", "single-pass-intersection"},
       "Two half-spaces that do not meet: one pass finds a hit."},
      {"expression/unions-restart-each-other",
       ground(steps),
       EntryAsk{{-0.5, 0, 0}, {5, 0, 0}},
       {"expression"},
       "Each union sends the other on: an intersection of them needs more than one round."},
      {"expression/unions-restart-each-other-often",
       ground(intersection_of({comb({0, 4, 8}), comb({2, 6, 8.5})})),
       EntryAsk{{-1, 0, 0}, {15, 0, 0}},
       {"expression"},
       "Gaps of one union lie where the other is: five rounds until both hold, from 8.5 to 9."},
      {"expression/parallels-at-other-lengths",
       {ground_materials(), intersection_of({half_space(0, 0, 4, 4), half_space(0, 0, 1, 2)})},
       EntryAsk{{0, 0, 3}, {0, 0, -1}},
       {"expression"},
       "Of z <= 1 and z <= 2 the first decides, though its offset is written larger."},
      {"expression/order-of-planes",
       ground(intersection_of({half_space(1, 0, 1, 1), half_space(0, 0, 1, 0)})),
       EntryAsk{{0, 0, 3}, {0, 0, -1}},
       {"expression"},
       "The later plane decides, whatever the order."},
      {"expression/nothing", {ground_materials(), {Nothing{}}}, down, {"empty"}, "Nothing is never hit."},
      {"expression/everything",
       {ground_materials(), {Everything{}}},
       down,
       {"empty", "inside"},
       "Everything has no border."},
      {"expression/empty-union", ground(union_of({})), down, {"empty"}, "The empty union is nothing."},
      {"expression/empty-intersection",
       ground(intersection_of({})),
       down,
       {"empty", "inside"},
       "The empty intersection is everything."},
      {"expression/zero-normal-everything",
       ground(half_space(0, 0, 0, 0)),
       down,
       {"empty", "inside"},
       "A half-space without a normal and d = 0 is everything: inside, never a border on it."},
      {"expression/zero-normal-nothing",
       ground(half_space(0, 0, 0, -0x1p-1074)),
       down,
       {"empty"},
       "A half-space without a normal and d < 0 is nothing."},
      {"expression/zero-normal-beside-a-face",
       ground(intersection_of({half_space(0, 0, 0, 0), half_space(0, 0, 1, 0)})),
       down,
       {"expression"},
       "The leaf without a normal counts in the numbering, but is no face."},
      {"expression/swallowed-leaf",
       ground(union_of(
           {intersection_of({half_space(0, 0, 1, 0), half_space(1, 0, 0, -5)}), half_space(0, 0, 1, 0)})),
       down,
       {"expression"},
       "The first leaf has the plane that is hit, but does not stand there: x <= -5 fails."},
      {"expression/nested-6-deep",
       ground(nested(6)),
       EntryAsk{{0, 0, 16}, {0, 0, -16}},
       {"expression"},
       "Unions and intersections in turns; the innermost plane decides."},
      {"expression/duplicate-operands",
       ground(intersection_of({half_space(0, 0, 1, 0), half_space(0, 0, 1, 0)})),
       down,
       {"expression", "seam"},
       "One plane twice: either leaf may be named."},
  };
}

}  // namespace groundtruth::cases
