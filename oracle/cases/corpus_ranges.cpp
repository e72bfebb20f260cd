// The range of lambda, and numbers at the ends of the doubles (SPEC sections 1 and 3).

#include "corpus_parts.hpp"

namespace groundtruth::cases {
namespace {

const Vector above{0, 0, 1};
const Vector below{0, 0, -1};

std::vector<Case> ranges() {
  const Scene flat = flat_ground();
  return {
      {"range/starts-behind-the-face",
       flat,
       EntryAsk{above, below, 0.75, 1},
       {"range", "inside"},
       "The range starts inside: the face before it does not count."},
      {"range/ends-before-the-face",
       flat,
       EntryAsk{above, below, 0, 0.25},
       {"range"},
       "The range ends too early: a miss."},
      {"range/ends-on-the-face",
       flat,
       EntryAsk{above, below, 0, 0.5},
       {"range"},
       "The last end counts: a hit at 1/2."},
      {"range/starts-on-the-face",
       flat,
       EntryAsk{above, below, 0.5, 1},
       {"range", "start-on-face"},
       "The first end stands on the face: border."},
      {"range/one-ulp-before-the-face",
       flat,
       EntryAsk{above, below, 0, 0x1.fffffffffffffp-2},
       {"range", "one-ulp"},
       "One ulp short of the face: a miss."},
      {"range/negative",
       flat,
       EntryAsk{below, above, -2, -1},
       {"range", "inside"},
       "A range before the first point."},
      {"range/beyond-the-ends",
       flat,
       EntryAsk{{0, 0, 4}, {0, 0, 3}, 0, 10},
       {"range"},
       "A hit at lambda = 4, beyond the second point."},
      {"range/of-one-point-on-the-face",
       flat,
       EntryAsk{above, below, 0.5, 0.5},
       {"range", "start-on-face"},
       "lambda_1 = lambda_2, on the face."},
      {"range/of-one-point-beside",
       flat,
       EntryAsk{above, below, 0.25, 0.25},
       {"range"},
       "lambda_1 = lambda_2, outside."},
      {"range/no-length",
       flat,
       EntryAsk{{0, 0, 0}, {0, 0, 0}, 0.25, 1},
       {"range", "start-on-face"},
       "From = to, on the face: border at the first end of the range."},
      {"range/from-2-to-the-63",
       {ground_materials(), {Nothing{}}},
       EntryAsk{above, below, 0x1p63, 0x1p63},
       {"range", "miss-is-plus-1000"},
       "Nothing is hit; in doubles lambda_2 + 1000 = lambda_2 here."},
      {"range/face-leaves-and-enters",
       ground(union_of({half_space(0, 0, 1, -1), half_space(0, 0, -1, -1)})),
       EntryAsk{{0, 0, 2}, {0, 0, -2}, 0.5, 1},
       {"range"},
       "Starts in the gap between two solids: the second is hit."},
  };
}

std::vector<Case> numbers() {
  const Scene far_box = ground(box({1e6, -1e6, 0}, {1000001, -999999, 1}));
  return {
      {"number/one-third",
       flat_ground(),
       EntryAsk{{0, 0, 1}, {0, 0, -2}},
       {"one-ulp"},
       "lambda = 1/3 is no double."},
      {"number/half-way-between-doubles",
       flat_ground(),
       EntryAsk{{0, 0, 0x1.0000000000001p+0}, {0, 0, -0x1.fffffffffffffp-1}},
       {"one-ulp"},
       "lambda lies near the middle of two doubles."},
      {"number/far-box-top",
       far_box,
       EntryAsk{{1000000.5, -999999.5, 3}, {1000000.5, -999999.5, -1}},
       {"big-world"},
       "A box 10^6 m away from the origin, from above."},
      {"number/far-box-edge",
       far_box,
       EntryAsk{{1000002, -999999.5, 2}, {1000000, -999999.5, 0}},
       {"big-world", "edge"},
       "Its edge: in single precision the world is a lattice of 1/16 m here."},
      {"number/far-oblique",
       ground(half_space(1, 2, 3, 6e6)),
       EntryAsk{{1e6, 1e6, 1000001}, {1e6, 1e6, 999999}},
       {"big-world"},
       "An oblique plane through (1e6, 1e6, 1e6)."},
      {"number/cancelling",
       ground(half_space(1, 1, 1, 1)),
       EntryAsk{{1e16, -1e16, 2}, {1e16, -1e16, 0}},
       {"big-world"},
       "The coordinates cancel: what is left is what decides."},
      {"number/long-segment",
       flat_ground(),
       EntryAsk{{0, 0, 1e-3}, {1e9, 0, -1e9}},
       {"big-world"},
       "A segment of 10^9 m that hits in its first thousandth of a millimetre."},
      {"number/tiny-world",
       ground(half_space(0, 0, 1, 0x1p-1074)),
       EntryAsk{{0, 0, 0x1p-1072}, {0, 0, 0}},
       {"one-ulp"},
       "Subnormal coordinates: lambda is 3/4."},
      {"number/huge-world",
       ground(half_space(0, 0, 1, 1e300)),
       EntryAsk{{0, 0, 1.5e308}, {0, 0, -1.5e308}},
       {"big-world"},
       "x_2 - x_1 overflows in doubles."},
      {"number/huge-normal",
       ground(half_space(0, 0, 1e308, 0)),
       EntryAsk{{0, 0, 1e10}, {0, 0, -1e10}},
       {"big-world"},
       "n . x overflows in doubles."},
      {"number/tiny-normal",
       ground(half_space(0, 0, 0x1p-1074, 0)),
       EntryAsk{{0, 0, 0.25}, {0, 0, -0.25}},
       {"one-ulp"},
       "n . x underflows to 0 in doubles."},
      {"number/almost-one-point",
       ground(intersection_of({half_space(1, 0, 1, 0), half_space(-1, 0, 0x1.0000000000001p+0, 0)})),
       EntryAsk{{0, 0, 3}, {0x1p-30, 0, -1}},
       {"one-ulp", "edge"},
       "Two planes whose crossings all but coincide."},
      {"number/near-parallel",
       ground(half_space(0x1p-40, 0, 1, 0)),
       EntryAsk{{-1, 0, 1}, {1, 0, 1}},
       {"grazing"},
       "Nearly parallel to the plane: a miss by a metre."},
  };
}

}  // namespace

std::vector<Case> corpus_of_ranges() {
  std::vector<Case> all = ranges();
  for (Case& one : numbers()) all.push_back(std::move(one));
  return all;
}

}  // namespace groundtruth::cases
