#include <groundtruth/fast/exact_stage/corner.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

// Bits of components: three products of four have four times as many, two more for their sums' and one for
// the sign.
constexpr int short_bits = 30;

// The least exponent of a component that is not 0.
int lowest_exponent(const Vector& v) {
  int lowest = 0;
  bool is_first = true;
  for (const double x : v) {
    if (x == 0) continue;
    lowest = is_first ? split(x).exponent : std::min(lowest, split(x).exponent);
    is_first = false;
  }
  return lowest;
}

bool is_short(const Vector& normal) {
  const int unit = lowest_exponent(normal);
  for (const double x : normal) {
    const auto [mantissa, exponent] = split(x);
    const auto magnitude = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
    if (mantissa != 0 && exponent - unit + static_cast<int>(std::bit_width(magnitude)) > short_bits)
      return false;
  }
  return true;
}

}  // namespace

bool have_short_normals(const Standing& standing) {
  const auto& leaves = standing.leaves();
  return std::all_of(leaves.begin(), leaves.end(),
                     [&](std::size_t leaf) { return is_short(standing.solid().leaves[leaf].normal); });
}

Normal<Dyadic> dyadic_normal(const HalfSpace& leaf) {
  return {leaf.normal[0], leaf.normal[1], leaf.normal[2]};
}

Normal<MachineInteger> machine_normal(const HalfSpace& leaf) {
  const int unit = lowest_exponent(leaf.normal);
  const auto component = [unit](double x) {
    const auto [mantissa, exponent] = split(x);
    return mantissa == 0 ? 0 : MachineInteger(mantissa) * (MachineInteger(1) << (exponent - unit));
  };
  return {component(leaf.normal[0]), component(leaf.normal[1]), component(leaf.normal[2])};
}

}  // namespace groundtruth::fast::exact_stage
