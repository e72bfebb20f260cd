#include <groundtruth/fast/cell.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundtruth::fast {

OpenLeaf open_leaf(std::uint32_t leaf, double delta_at_first, double delta_at_last, double error) {
  const double w = delta_at_first - delta_at_last;
  if (!(std::abs(w) > 2 * error)) return {.leaf = leaf};
  const double inverse = 1 / w, middle = delta_at_first * inverse, margin = error * std::abs(inverse);
  return {middle - margin, middle + margin, leaf, w > 0 ? Turn::enters : Turn::leaves};
}

bool is_apart(const PackedCells& cells, const Cell& cell, const Box& box) {
  if (box.is_empty()) return true;
  for (std::uint32_t place = 0; place != cell.leaf_count; ++place) {
    const auto& [n, d] = cells.half_space_at(cell, place);
    if (greatest_delta({{-n[0], -n[1], -n[2]}, -d}, box) < 0) return true;
  }
  return false;
}

void add_open_leaves(const PackedCells& cells, const Cell& cell, const Probe& probe, OpenLeaves& leaves) {
  const double error = probe.error_bound(double{cell.normal_size}, double{cell.offset_size});
  const Vector &x = probe.ends().first, &y = probe.ends().last;
  for (std::uint32_t place = 0; place != cell.leaf_count; ++place) {
    OpenLeaf open{.leaf = place};
    if (error < greatest_usable_error) {
      const auto& [n, d] = cells.half_space_at(cell, place);
      const double a = n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - d;
      const double b = n[0] * y[0] + n[1] * y[1] + n[2] * y[2] - d;
      if (a < -error && b < -error) continue;
      open = open_leaf(place, a, b, error);
    }
    leaves.push_back(open);
  }
}

namespace {

float no_less_than(double x) {
  const auto rounded = static_cast<float>(x);
  return double{rounded} >= x ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

}  // namespace

void PackedCells::add(std::span<const std::uint32_t> numbers, std::span<const HalfSpace> half_spaces) {
  Cell cell{.first_group = static_cast<std::uint32_t>(groups.size()),
            .leaf_count = static_cast<std::uint32_t>(numbers.size())};
  double normal_size = 0, offset_size = 0;
  bool is_listed = false;
  for (std::uint32_t place = 0; place != cell.leaf_count; ++place) {
    const std::uint32_t lane = place % 4;
    if (lane == 0) groups.push_back({{}, {}, {}, {0x1p1000, 0x1p1000, 0x1p1000, 0x1p1000}});
    HalfSpaces4& group = groups.back();
    const auto& [normal, offset] = half_spaces[place];
    group.normal_x[lane] = normal[0];
    group.normal_y[lane] = normal[1];
    group.normal_z[lane] = normal[2];
    group.offset[lane] = offset;
    normal_size = std::max(normal_size, std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]));
    offset_size = std::max(offset_size, std::abs(offset));
    is_listed |= numbers[place] != numbers[0] + place;
  }
  // A sum of three is off by less than 2^-50 of itself.
  cell.normal_size = no_less_than(normal_size * (1 + 0x1p-50));
  cell.offset_size = no_less_than(offset_size);
  if (!numbers.empty()) cell.first_leaf = numbers[0];
  if (is_listed) {
    cell.listed_at = static_cast<std::uint32_t>(leaves.size());
    leaves.insert(leaves.end(), numbers.begin(), numbers.end());
  }
  cells.push_back(cell);
}

}  // namespace groundtruth::fast
