#include <array>
#include <cmath>

#include <groundtruth/cases/border_cases.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

constexpr std::array<RationalNormal, 14> rational_normals{{{{0, 0, -1}, 1, 1},
                                                           {{0, 0, -2}, 2, 2},
                                                           {{3, 0, -4}, 5, 5},
                                                           {{-4, 0, -3}, 5, 5},
                                                           {{0, 3, -4}, 4, 5},
                                                           {{0, -4, -3}, 3, 5},
                                                           {{5, 0, -12}, 13, 13},
                                                           {{0, -5, -12}, 12, 13},
                                                           {{-8, 0, -15}, 17, 17},
                                                           {{3, 12, -4}, 5, 13},
                                                           {{4, -12, -3}, 5, 13},
                                                           {{12, 20, -9}, 15, 25},
                                                           {{9, -8, -12}, 15, 17},
                                                           {{12, 84, -5}, 13, 85}}};

struct Triangle {
  double a = 0;
  double b = 0;
  double hypotenuse = 0;
};

constexpr std::array<Triangle, 8> triangles{
    {{3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {12, 5, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {40, 9, 41}}};

// A force in the first quadrant, in the units of the triangle, and half the band's width.
struct Quadrant {
  double x = 0;
  double y = 0;
  double band = 0;
};

Quadrant place_force(BorderPlace place, const Triangle& t, Random& random) {
  const double step = random.dyadic(1, 8, 0) / 4;
  switch (place) {
    case BorderPlace::disc:
      return {t.a, t.b, t.a + step};
    case BorderPlace::band_edge:
      return {t.a, t.b * random.dyadic(0, 7, 0) / 8, t.a};
    case BorderPlace::corner:
      return {t.a, t.b, t.a};
    case BorderPlace::between_1_and_2:
      return {t.a + step, t.b, t.a};
    case BorderPlace::between_2_and_3:
      return {t.a * (1 + step), t.b * (1 + step), t.a};
    case BorderPlace::wide_band:
      break;
  }
  return {t.a * step, t.b * step, t.hypotenuse};
}

}  // namespace

const RationalNormal& pick_rational_normal(Random& random) { return random.pick(rational_normals); }

Vector force_of_surface_force(const RationalNormal& surface, const Vector& force_in_surface) {
  const Vector& n = surface.normal;
  const double r = surface.r;
  const Vector along = times(surface.length, {-n[2], 0, n[0]});
  const Vector sideways{-n[0] * n[1], r * r, -n[1] * n[2]};
  const Vector down = times(-r, n);
  return plus(plus(times(force_in_surface[0], along), times(force_in_surface[1], sideways)),
              times(force_in_surface[2], down));
}

BorderCase border_case(BorderPlace place, Pressing pressing, double unit, Random& random) {
  const RationalNormal& surface = pick_rational_normal(random);
  const Triangle& triangle = random.pick(triangles);
  const Quadrant at = place_force(place, triangle, random);
  // mu = hypotenuse / pressure, so that the disc's radius is the hypotenuse.
  const double pressure = std::ldexp(1.0, static_cast<int>(random.between(2, 6)));
  const double sign_x = random.sign();
  const double sign_y = random.sign();
  const double sign_z = pressing == Pressing::yes ? 1 : random.sign();
  const Vector force = force_of_surface_force(surface, {sign_x * at.x, sign_y * at.y, sign_z * pressure});
  BorderCase result{surface, times(unit, force), triangle.hypotenuse / pressure,
                    unit * surface.r * surface.length * at.band};
  if (place == BorderPlace::disc && random.one_in(4)) result.brake = std::ldexp(unit, 40);
  return result;
}

}  // namespace groundtruth::cases
