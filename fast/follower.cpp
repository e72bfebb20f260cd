#include <groundtruth/fast/follower.hpp>

#include <algorithm>
#include <cmath>

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/decided_entry.hpp>
#include <groundtruth/fast/search.hpp>

namespace groundtruth::fast {

namespace {

// Exactly, rounding of the ends and of the sums here included.
bool holds(const Box& box, const RangeEnds& ends) {
  const double margin = 2 * ends.coordinate_error;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(std::min(ends.first[axis], ends.last[axis]) - margin >= box.low[axis] &&
          std::max(ends.first[axis], ends.last[axis]) + margin <= box.high[axis]))
      return false;
  return true;
}

double greatest_difference(const Vector& a, const Vector& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

// From one range to the next.
double way_between(const RangeEnds& one, const RangeEnds& next) {
  return std::max(greatest_difference(one.first, next.first), greatest_difference(one.last, next.last));
}

constexpr Part all_parts[Neighbourhood::most_cells] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

void search(const Scene& scene, const PackedCells& cells, const Probe& probe, SearchResult& result) {
  SearchTask task = search_task(scene, cells, probe, result);
  scene.parts().kernels->visit_parts(task, all_parts, all_parts + cells.cells.size());
  result.drop_late_ones();
}

}  // namespace

EntryAnswer Follower::entry_point(const EntryAsk& ask) {
  EntryAnswer answer;
  const Probe probe(ask);
  if (!is_known(probe.ends())) {
    decide_entry(scene_, ask, answer);
    return answer;
  }
  SearchResult result;
  search(scene_, near_.cells(), probe, result);
  if (result.starts_inside) {
    answer = Inside{ask.lambda_first + 0.0};
  } else if (result.contenders.empty()) {
    answer = Miss{};
  } else if (const Face face = sole_face(near_.cells(), result); face.leaf != no_leaf) {
    answer_with_face(scene_, probe, ask, result, face, answer);
  } else {
    decide_entry(scene_, ask, answer);
  }
  return answer;
}

bool Follower::is_known(const RangeEnds& ends) {
  if (known_ != Known::nothing && holds(box_, ends)) {
    ++served_;
    return known_ == Known::all;
  }
  constexpr double near = 0.25;  // of a range's length
  const bool is_near = way_between(last_, ends) <= near * greatest_difference(ends.first, ends.last);
  near_in_a_row_ = is_near ? near_in_a_row_ + 1 : 0;
  const bool is_worth_it = near_in_a_row_ >= patience_;
  if (is_worth_it) look_ahead(ends);
  last_ = ends;
  return is_worth_it && known_ == Known::all && holds(box_, ends);
}

// To where the next steps lead if they are like the last one, and a few of them to all sides.
void Follower::look_ahead(const RangeEnds& ends) {
  constexpr double steps_ahead = 64, steps_aside = 8;
  constexpr unsigned few = 16, most_patience = 256;
  patience_ = served_ < few ? std::min(2 * patience_, most_patience) : 1;
  served_ = near_in_a_row_ = 0;
  const double margin = steps_aside * way_between(last_, ends) + 2 * ends.coordinate_error;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double ahead = steps_ahead * (ends.first[axis] - last_.first[axis]);
    box_.low[axis] = std::min(ends.first[axis], ends.last[axis]) + std::min(ahead, 0.0) - margin;
    box_.high[axis] = std::max(ends.first[axis], ends.last[axis]) + std::max(ahead, 0.0) + margin;
  }
  known_ = near_.look_around(scene_, box_) ? Known::all : Known::too_much;
}

}  // namespace groundtruth::fast
