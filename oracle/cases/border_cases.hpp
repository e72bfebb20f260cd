#pragma once
// Forces that lie exactly on the borders between the cases of SPEC section 4, in doubles: possible because
// there are normals whose lengths are rational, and right triangles with integer sides.

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

// A normal with integer coordinates, |normal| and r = sqrt(n_x^2 + n_z^2) integers too, and n_z < 0.
struct RationalNormal {
  Vector normal{};
  double r = 0;
  double length = 0;
};

const RationalNormal& pick_rational_normal(Random& random);

// The force whose coordinates in the frame of the surface are r |n| (x, y, z). Exact for short x, y, z.
Vector force_of_surface_force(const RationalNormal& surface, const Vector& force_in_surface);

enum class BorderPlace {
  disc,             // on the disc's border, in the band: stick
  band_edge,        // on the band's edge, in the disc: stick
  corner,           // on both: stick
  between_1_and_2,  // |F'_x| > B, |F'_y| = s
  between_2_and_3,  // outside, on the ray through the corner
  wide_band,        // B = mu N; inside, on the border or outside
};

enum class Pressing { yes, either_way };  // is F'_z > 0, or has it either sign?

struct BorderCase {
  RationalNormal surface;
  Vector force_in_wheel{};
  double friction = 0;
  double brake = 0;
};

// Coordinates are integers below 2^21 times `unit`, which must be a power of two; friction and brake are
// dyadic too.
BorderCase border_case(BorderPlace place, Pressing pressing, double unit, Random& random);

}  // namespace groundtruth::cases
