#include <groundtruth/fast/cell.hpp>

#include <cmath>
#include <limits>

#include <groundtruth/fast/lanes.hpp>

namespace groundtruth::fast {

namespace {

const Lanes before_range = Lanes::all(-1), one = Lanes::all(1), after_range = Lanes::all(2);

double greatest(const Lanes& x) { return std::max(std::max(x[0], x[1]), std::max(x[2], x[3])); }
double least(const Lanes& x) { return std::min(std::min(x[0], x[1]), std::min(x[2], x[3])); }

// Where four half-spaces are crossed.
struct Crossings {
  Lanes::Choice is_inside;  // certainly, at both ends
  Lanes::Choice is_outside;
  Lanes::Choice enters;  // certainly; so does the next
  Lanes::Choice leaves;
  Lanes lower;
  Lanes upper;
};

class Crosser {
 public:
  Crosser(const Probe& probe, double error)
      : first_x_(Lanes::all(probe.ends().first[0])),
        first_y_(Lanes::all(probe.ends().first[1])),
        first_z_(Lanes::all(probe.ends().first[2])),
        last_x_(Lanes::all(probe.ends().last[0])),
        last_y_(Lanes::all(probe.ends().last[1])),
        last_z_(Lanes::all(probe.ends().last[2])),
        error_(Lanes::all(error)),
        twice_error_(Lanes::all(2 * error)) {}

  [[gnu::always_inline]] inline void cross(const HalfSpaces4& group, Crossings& crossings) const {
    const Lanes x = Lanes::load(group.normal_x);
    const Lanes y = Lanes::load(group.normal_y);
    const Lanes z = Lanes::load(group.normal_z);
    const Lanes offset = Lanes::load(group.offset);
    const Lanes a = x * first_x_ + y * first_y_ + z * first_z_ - offset;
    const Lanes b = x * last_x_ + y * last_y_ + z * last_z_ - offset;
    const Lanes w = a - b;
    crossings.is_inside = (a < -error_) & (b < -error_);
    crossings.is_outside = (a > error_) & (b > error_);
    crossings.enters = w > twice_error_;
    crossings.leaves = w < -twice_error_;
    const Lanes crossing_w = choose(crossings.enters | crossings.leaves, w, one);
    const Lanes inverse = one / crossing_w;
    const Lanes middle = a * inverse;
    const Lanes margin = error_ * inverse;
    crossings.lower = choose(crossings.enters, middle - margin, middle + margin);
    crossings.upper = choose(crossings.enters, middle + margin, middle - margin);
  }

 private:
  Lanes first_x_, first_y_, first_z_, last_x_, last_y_, last_z_, error_, twice_error_;
};

double error_bound(const Cell& cell, const Probe& probe) {
  return probe.error_bound(double{cell.normal_size}, double{cell.offset_size});
}

}  // namespace

Meeting meet(const PackedCells& cells, const Cell& cell, const Probe& probe) {
  const double error = error_bound(cell, probe);
  if (!(error < greatest_usable_error)) return {};
  const Crosser crosser(probe, error);
  Lanes enter_lower = before_range, enter_upper = before_range, exit_lower = after_range,
        exit_upper = after_range;
  Lanes::Choice is_outside{}, is_undecided{};
  for (std::uint32_t i = cell.first_group; i != cell.end_group; ++i) {
    Crossings at;
    crosser.cross(cells.groups[i], at);
    is_outside = is_outside | at.is_outside;
    is_undecided = is_undecided | ~(at.enters | at.leaves | at.is_inside);
    enter_lower = greater(choose(at.enters, at.lower, before_range), enter_lower);
    enter_upper = greater(choose(at.enters, at.upper, before_range), enter_upper);
    exit_lower = lesser(choose(at.leaves, at.lower, after_range), exit_lower);
    exit_upper = lesser(choose(at.leaves, at.upper, after_range), exit_upper);
  }
  if (is_outside.any()) return no_meeting;
  const double lower = std::max(greatest(enter_lower), 0.0);
  if (lower > 1 || lower > least(exit_upper)) return no_meeting;
  const double upper = greatest(enter_upper);
  const bool is_certain =
      !is_undecided.any() && upper <= 1 && upper <= least(exit_lower) && least(exit_lower) > 0;
  return {lower, is_certain ? upper : 2};
}

Face sole_face(const PackedCells& cells, const Cell& cell, const Probe& probe, const Meeting& meeting) {
  if (!(meeting.lower > 0)) return {};
  const Crosser crosser(probe, error_bound(cell, probe));
  std::uint32_t found = 0, faces = 0;
  for (std::uint32_t i = cell.first_group; i != cell.end_group; ++i) {
    Crossings at;
    crosser.cross(cells.groups[i], at);
    const Lanes::Choice touches = (at.enters & (at.upper >= Lanes::all(meeting.lower))) |
                                  (at.leaves & (at.lower <= Lanes::all(meeting.upper)));
    for (int lane = 0; lane < 4; ++lane) {
      if (!touches[lane]) continue;
      found = 4 * i + static_cast<std::uint32_t>(lane);
      ++faces;
    }
  }
  if (faces != 1) return {};
  const HalfSpaces4& group = cells.groups[found / 4];
  const std::uint32_t lane = found % 4;
  const std::uint32_t leaf =
      cell.first_leaf != no_leaf ? cell.first_leaf + (found - 4 * cell.first_group) : cells.leaves[found];
  return {leaf,
          {{group.normal_x[lane], group.normal_y[lane], group.normal_z[lane]}, group.offset[lane]},
          cell.material};
}

OpenLeaf open_leaf(std::uint32_t leaf, double delta_at_first, double delta_at_last, double error) {
  const double w = delta_at_first - delta_at_last;
  if (!(std::abs(w) > 2 * error)) return {.leaf = leaf};
  const double inverse = 1 / w, middle = delta_at_first * inverse, margin = error * std::abs(inverse);
  return {middle - margin, middle + margin, leaf, w > 0 ? Turn::enters : Turn::leaves};
}

void add_open_leaves(const PackedCells& cells, const Cell& cell, const Probe& probe, OpenLeaves& leaves) {
  const double error = error_bound(cell, probe);
  const Crosser crosser(probe, error);
  for (std::uint32_t group = cell.first_group; group != cell.end_group; ++group) {
    Crossings at{};
    if (error < greatest_usable_error) crosser.cross(cells.groups[group], at);
    for (int lane = 0; lane < 4; ++lane) {
      const std::uint32_t leaf = cells.leaves[4 * group + static_cast<std::uint32_t>(lane)];
      if (leaf == no_leaf || at.is_inside[lane]) continue;
      if (at.enters[lane] || at.leaves[lane])
        leaves.push_back(
            {at.lower[lane], at.upper[lane], leaf, at.enters[lane] ? Turn::enters : Turn::leaves});
      else
        leaves.push_back({.leaf = leaf});
    }
  }
}

void PackedCells::begin_cell() {
  const auto place = static_cast<std::uint32_t>(groups.size());
  cells.push_back({.first_group = place, .end_group = place});
}

namespace {

float no_less_than(double x) {
  const auto rounded = static_cast<float>(x);
  return double{rounded} >= x ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

}  // namespace

void PackedCells::add(const HalfSpace& half_space, Leaf leaf) {
  Cell& cell = cells.back();
  std::uint32_t place = 4 * cell.first_group;
  while (place != 4 * cell.end_group && leaves[place] != no_leaf) ++place;
  if (place == 4 * cell.end_group) {
    groups.push_back({{}, {}, {}, {0x1p1000, 0x1p1000, 0x1p1000, 0x1p1000}});
    leaves.insert(leaves.end(), 4, no_leaf);
    ++cell.end_group;
  }
  HalfSpaces4& group = groups[place / 4];
  const auto& [normal, offset] = half_space;
  group.normal_x[place % 4] = normal[0];
  group.normal_y[place % 4] = normal[1];
  group.normal_z[place % 4] = normal[2];
  group.offset[place % 4] = offset;
  leaves[place] = static_cast<std::uint32_t>(leaf);
  const std::uint32_t count = place - 4 * cell.first_group;
  if (count == 0)
    cell.first_leaf = leaves[place];
  else if (cell.first_leaf == no_leaf || cell.first_leaf + count != leaves[place])
    cell.first_leaf = no_leaf;
  // A sum of three is off by less than 2^-50 of itself.
  const double normal_size =
      (std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2])) * (1 + 0x1p-50);
  cell.normal_size = std::max(cell.normal_size, no_less_than(normal_size));
  cell.offset_size = std::max(cell.offset_size, no_less_than(std::abs(offset)));
}

}  // namespace groundtruth::fast
