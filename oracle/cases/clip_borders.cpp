// Clip asks exactly on the borders between cases.

#include <cmath>

#include <groundtruth/cases/border_cases.hpp>
#include <groundtruth/cases/clip_flavours.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

// Mostly newtons to kilonewtons; now and then far beyond both ends, though squares stay in the range of
// doubles for the most part.
double random_unit(Random& random) {
  if (random.one_in(16)) return std::ldexp(1.0, static_cast<int>(random.between(300, 960)));
  if (random.one_in(16)) return std::ldexp(1.0, static_cast<int>(random.between(-1040, -300)));
  return std::ldexp(1.0, static_cast<int>(random.between(-12, 12)));
}

ClipAsk on_border(BorderPlace place, Random& random) {
  const double unit = random_unit(random);
  const BorderCase border = border_case(place, Pressing::either_way, unit, random);
  ClipAsk ask{border.force_in_wheel, border.surface.normal, border.friction, border.brake};
  // Of the normals, the steepest has n_z / |n_xy| = 0.0589.
  if (!random.one_in(4)) ask.min_uprightness = 0.03125;
  return ask;
}

}  // namespace

ClipAsk clip_disc_border(Random& random) { return on_border(BorderPlace::disc, random); }
ClipAsk clip_band_edge(Random& random) { return on_border(BorderPlace::band_edge, random); }
ClipAsk clip_border_corner(Random& random) { return on_border(BorderPlace::corner, random); }
ClipAsk clip_case_border_1_2(Random& random) { return on_border(BorderPlace::between_1_and_2, random); }
ClipAsk clip_case_border_2_3(Random& random) { return on_border(BorderPlace::between_2_and_3, random); }
ClipAsk clip_wide_band(Random& random) { return on_border(BorderPlace::wide_band, random); }

ClipAsk clip_zeros(Random& random) {
  const RationalNormal& surface = pick_rational_normal(random);
  Vector force{random.dyadic(-9, 9, 0), random.dyadic(-9, 9, 0), random.dyadic(-9, 9, 0)};
  ClipAsk ask;
  ask.friction = random.dyadic(0, 16, 0) / 8;
  ask.brake = random.dyadic(0, 200, 0);
  const std::uint64_t what = random.below(6);
  if (what == 0) force = {0, 0, 0};
  if (what == 1) force[2] = 0;
  if (what == 2) force = {0, 0, force[2]};
  if (what == 3) force[random.below(2)] = 0;
  if (what == 4) ask.friction = 0;
  if (what == 5) ask.brake = 0;
  if (random.one_in(8)) ask.friction = ask.brake = 0;
  ask.force_in_wheel = force_of_surface_force(surface, force);
  ask.normal_in_wheel = surface.normal;
  ask.min_uprightness = 0.03125;
  return ask;
}

ClipAsk clip_steepness_limit(Random& random) {
  ClipAsk ask = on_border(BorderPlace::disc, random);
  // n_z^2 = t^2 (n_x^2 + n_y^2) with a triangle of sides 3, 4, 5 in the plane.
  const double scale = random.dyadic(1, 16, 0);
  const double x = random.sign() * scale;
  const double y = random.sign() * scale;
  ask.min_uprightness = std::ldexp(1.0, static_cast<int>(random.between(-6, 3)));
  ask.normal_in_wheel = {3 * x, 4 * y, -5 * scale * ask.min_uprightness};
  if (random.one_in(2)) ask.normal_in_wheel = {x, 0, -scale * ask.min_uprightness};
  return ask;
}

}  // namespace groundtruth::cases
