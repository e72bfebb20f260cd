#include <cmath>

#include <groundtruth/tests/properties/shrinking.hpp>

namespace groundtruth::properties {
namespace {

// n with rational r = sqrt(n_x^2 + n_z^2) and ||n||.
struct RationalSurface {
  Vector normal;
  double r;
  double length;
};
const std::vector<RationalSurface> rational_surfaces{
    {{0, 0, -1}, 1, 1},    {{3, 0, -4}, 5, 5},    {{-3, 0, -4}, 5, 5},
    {{0, 3, -4}, 4, 5},    {{0, -4, -3}, 3, 5},   {{3, 12, -4}, 5, 13},
    {{-4, 12, -3}, 5, 13}, {{3, -12, -4}, 5, 13}, {{0, 0, -0x1p-500}, 0x1p-500, 0x1p-500}};

ClipAsk lattice_clip(Dice& dice) {
  ClipAsk ask;
  ask.force_in_wheel = lattice_vector(dice, dice.pick({1, 4, 12}));
  ask.normal_in_wheel = lattice_normal(dice);
  if (!dice.one_in(8)) ask.normal_in_wheel[2] = -dice.whole(1, 4);
  ask.friction = dice.whole(0, 8) / 4.0;
  ask.brake = dice.whole(0, 12) / 2.0;
  if (dice.one_in(4)) ask.min_uprightness = dice.pick({0.5, 1.0, 2.0, 0x1p-30});
  return ask;
}

// F' = x X + y Y + z Z, exact if x, y and z are whole multiples of r ||n||.
Vector in_wheel(const RationalSurface& surface, double x, double y, double z) {
  const auto& [n, r, length] = surface;
  return {-n[2] * x / r - n[0] * n[1] * y / (r * length) - n[0] * z / length,
          r * y / length - n[1] * z / length,
          n[0] * x / r - n[1] * n[2] * y / (r * length) - n[2] * z / length};
}

ClipAsk border_clip(Dice& dice) {
  const RationalSurface surface = dice.pick(rational_surfaces);
  const double unit = dice.pick({65.0, 130.0, 260.0});
  // Legs and hypotenuse of right triangles: points of the disc's edge, and B with rational s.
  const auto [a, b, c] =
      dice.pick<std::array<int, 3>>({{3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {0, 1, 1}, {1, 0, 1}, {8, 15, 17}});
  ClipAsk ask;
  ask.normal_in_wheel = surface.normal;
  ask.friction = dice.pick({0.25, 0.5, 1.0, 2.0});
  const double radius = c * unit;
  ask.brake = dice.pick({a * unit, radius, 2 * radius, 0.0, (a + 1) * unit});
  const double side_x = dice.pick({-1.0, 1.0});
  const double side_y = dice.pick({-1.0, 1.0});
  const double outward = dice.pick({1.0, 1.0, 2.0, 0.5});
  const double sideways = dice.pick({0.0, 0.0, 1.0, 3.0}) * unit;
  const double normal = dice.pick({-1.0, 1.0}) * radius / ask.friction;
  ask.force_in_wheel =
      in_wheel(surface, side_x * (a * unit * outward + sideways), side_y * b * unit * outward, normal);
  if (dice.one_in(3)) {
    for (double& f : ask.force_in_wheel) f = wobbled(f, dice, 100);
    ask.brake = std::fabs(wobbled(ask.brake, dice, 100));
  }
  return ask;
}

ClipAsk wild_clip(Dice& dice) {
  // Seldom all of them odd, as exact numbers of thousands of digits take the second witness long.
  const int odd_one_in = dice.one_in(32) ? 1 : dice.pick({8, 100, 100});
  const auto number = [&] {
    if (dice.one_in(odd_one_in)) return any_double(dice);
    return std::ldexp(static_cast<double>(dice.bits() >> 11), dice.whole(-56, -50)) * dice.pick({-1, 1});
  };
  ClipAsk ask;
  for (double& f : ask.force_in_wheel) f = number();
  for (double& n : ask.normal_in_wheel) n = number();
  if (!dice.one_in(6)) ask.normal_in_wheel[2] = -std::fabs(ask.normal_in_wheel[2]);
  ask.friction = std::fabs(number());
  ask.brake = std::fabs(number());
  if (dice.one_in(3)) ask.min_uprightness = std::fabs(number());
  if (ask.min_uprightness == 0) ask.min_uprightness = default_min_uprightness;
  return ask;
}

}  // namespace

rc::Gen<ClipAsk> lattice_clips() { return shrinking(lattice_clip); }
rc::Gen<ClipAsk> border_clips() { return shrinking(border_clip); }
rc::Gen<ClipAsk> wild_clips() { return shrinking(wild_clip); }

}  // namespace groundtruth::properties
