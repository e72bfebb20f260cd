#include <groundtruth/as_written/surface_frame.hpp>

namespace groundtruth::as_written {
namespace {

struct Angle {
  double cosine;
  double sine;
};

Angle opposite(const Angle& angle) { return {angle.cosine, -angle.sine}; }

// The columns of q_y q_x: first a turn about x, then one about y.
Axes turned(const Angle& about_x, const Angle& about_y) {
  return {{about_y.cosine, 0, -about_y.sine},
          {about_y.sine * about_x.sine, about_x.cosine, about_y.cosine * about_x.sine},
          {about_y.sine * about_x.cosine, -about_x.sine, about_y.cosine * about_x.cosine}};
}

bool is_too_steep(const Vector& n, double min_uprightness) {
  const double upright = -n[2] / min_uprightness;
  return !(n[2] < 0) || upright * upright < n[0] * n[0] + n[1] * n[1];
}

}  // namespace

std::optional<Axes> surface_frame(const Vector& normal_in_wheel, double min_uprightness,
                                  const Errata& errata) {
  const Vector n = scaled_near_one(normal_in_wheel);
  if (is_too_steep(n, min_uprightness)) {
    return std::nullopt;
  }
  const double r = length(n[0], n[2]);
  const double whole = length(r, n[1]);
  const Angle phi_x{r / whole, n[1] / whole};
  const Angle phi_y{-n[2] / r, -n[0] / r};
  return errata.has(Erratum::surface_frame_sign) ? turned(opposite(phi_x), opposite(phi_y))
                                                 : turned(phi_x, phi_y);
}

}  // namespace groundtruth::as_written
