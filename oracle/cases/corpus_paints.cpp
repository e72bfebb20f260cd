// Paint and covers (SPEC section 2).

#include "corpus_parts.hpp"

namespace groundtruth::cases {
namespace {

const EntryAsk down{{0, 0, 1}, {0, 0, -1}};

std::vector<Case> rims_and_layers() {
  const Shape floor = half_space(0, 0, 1, 0);
  const Shape right = half_space(-1, 0, 0, 0);  // x >= 0
  return {
      {"paint/on-the-rim",
       {ground_materials(), painted(icy, right, covered(dry, floor))},
       down,
       {"paint"},
       "On the very border of a region of paint: the region is closed."},
      {"paint/one-ulp-beside",
       {ground_materials(), painted(icy, right, covered(dry, floor))},
       EntryAsk{{-0x1p-1074, 0, 1}, {-0x1p-1074, 0, -1}},
       {"paint", "one-ulp"},
       "Beside the paint by the least double."},
      {"paint/outermost-wins",
       {ground_materials(), painted(wet, right, painted(icy, right, covered(dry, floor)))},
       down,
       {"paint"},
       "Of two paints the outer one counts."},
      {"paint/cover-over-paint",
       {ground_materials(), covered(dirty, painted(icy, right, floor))},
       down,
       {"paint"},
       "A cover outside hides the paint beneath."},
      {"paint/no-material",
       {ground_materials(), painted(icy, half_space(-1, 0, 0, -1), floor)},
       down,
       {"paint"},
       "Outside the paint and without a cover: the material is none."},
      {"paint/leaves-of-the-region",
       {ground_materials(), painted(icy, right, union_of({covered(dry, floor), right}))},
       EntryAsk{{-1, 0, 1}, {1, 0, 1}},
       {"paint"},
       "Half-spaces of a region are no leaves and do not shift the numbers."},
      {"paint/seam-of-two-materials",
       {ground_materials(),
        union_of({covered(dry, box({-1, -1, -1}, {0, 1, 0})), covered(icy, box({0, -1, -1}, {1, 1, 0}))})},
       down,
       {"paint", "seam"},
       "Two materials meet where the segment hits: each with its own leaf."},
  };
}

// Dry ground with ice on a region.
Scene iced(Shape where) {
  return {ground_materials(), painted(icy, std::move(where), covered(dry, half_space(0, 0, 1, 0)))};
}

// Regions are shapes like any other.
std::vector<Case> odd_regions() {
  const Shape right = half_space(-1, 0, 0, 0);    // x >= 0
  const Shape beyond = half_space(-1, 0, 0, -1);  // x >= 1
  return {
      {"paint/on-everything", iced({Everything{}}), down, {"paint"}, "Everything is a region: all is ice."},
      {"paint/on-nothing", iced({Nothing{}}), down, {"paint"}, "Nothing is a region: no ice."},
      {"paint/on-the-empty-intersection",
       iced(intersection_of({})),
       down,
       {"paint", "empty"},
       "The empty intersection is everything, as a region too."},
      {"paint/on-the-empty-union",
       iced(union_of({})),
       down,
       {"paint", "empty"},
       "The empty union is nothing, as a region too."},
      {"paint/where-zero-is-at-most-zero",
       iced(half_space(0, 0, 0, 0)),
       down,
       {"paint", "empty"},
       "A half-space without a normal and d = 0 is everything, as a region too."},
      {"paint/on-a-union",
       iced(union_of({beyond, right})),
       down,
       {"paint"},
       "The second operand of the region's union holds the point."},
      {"paint/on-an-intersection",
       iced(intersection_of({right, beyond})),
       down,
       {"paint"},
       "The second operand of the region's intersection does not hold the point."},
      {"paint/on-a-covered-region",
       iced(covered(wet, right)),
       down,
       {"paint"},
       "Materials within a region mean nothing: it is the place that counts."},
      {"paint/on-a-painted-region",
       iced(painted(wet, beyond, right)),
       down,
       {"paint"},
       "Paint within a region means nothing: it is the place that counts."},
  };
}

}  // namespace

std::vector<Case> corpus_of_paints() {
  std::vector<Case> all = rims_and_layers();
  for (Case& one : odd_regions()) all.push_back(std::move(one));
  return all;
}

}  // namespace groundtruth::cases
