// Mistakes in the clip's formulas.

#include <algorithm>

#include "plain_clip.hpp"

namespace groundtruth::planted {
namespace {

struct Radial : PlainClip {
  Tangential slide(const Grasp& grasp) const override { return on_disc(grasp); }
};

struct CornerForDisc : PlainClip {
  Tangential slide(const Grasp& grasp) const override {
    const bool is_cut = grasp.brake < grasp.radius && abs(grasp.force_on_surface[1]) > half_chord(grasp);
    return is_cut ? at_corner(grasp) : PlainClip::slide(grasp);
  }
};

// First into the band, then towards the middle into the disc: not the nearest point.
struct BandThenDisc : PlainClip {
  Tangential slide(const Grasp& grasp) const override {
    Grasp banded = grasp;
    Number& x = banded.force_on_surface[0];
    if (abs(x) > grasp.brake) x = with_sign_of(x, grasp.brake);
    return is_in_disc(banded) ? Tangential{x, banded.force_on_surface[1]} : on_disc(banded);
  }
};

// Half axes B and mu N.
struct Ellipse : PlainClip {
  bool sticks(const Grasp& grasp) const override { return PlainClip::sticks(grasp) && excess(grasp) <= 1; }
  Tangential slide(const Grasp& grasp) const override {
    if (grasp.brake >= grasp.radius) return on_disc(grasp);
    const Number size = sqrt(excess(grasp));
    return {grasp.force_on_surface[0] / size, grasp.force_on_surface[1] / size};
  }
  static Number excess(const Grasp& grasp) {
    if (grasp.brake >= grasp.radius || grasp.brake == 0) return 1;
    const Number x = grasp.force_on_surface[0] / grasp.brake, y = grasp.force_on_surface[1] / grasp.radius;
    return x * x + y * y;
  }
};

struct NoBandBackwards : PlainClip {
  bool sticks(const Grasp& grasp) const override { return PlainClip::sticks(unbanded(grasp)); }
  Tangential slide(const Grasp& grasp) const override { return PlainClip::slide(unbanded(grasp)); }
  static Grasp unbanded(Grasp grasp) {
    if (grasp.force_on_surface[0] < 0) grasp.brake = std::max(grasp.brake, abs(grasp.radius));
    return grasp;
  }
};

struct NoBandUnbraked : PlainClip {
  bool sticks(const Grasp& grasp) const override { return PlainClip::sticks(braked(grasp)); }
  Tangential slide(const Grasp& grasp) const override { return PlainClip::slide(braked(grasp)); }
  static Grasp braked(Grasp grasp) {
    if (grasp.brake == 0) grasp.brake = abs(grasp.radius);
    return grasp;
  }
};

struct ForwardOnly : PlainClip {
  Tangential slide(const Grasp& grasp) const override {
    const Tangential h = PlainClip::slide(grasp);
    return abs(h.x) == grasp.brake ? Tangential{grasp.brake, h.y} : h;
  }
};

struct RightOnly : PlainClip {
  Tangential slide(const Grasp& grasp) const override {
    const Tangential h = PlainClip::slide(grasp);
    const bool is_corner = abs(h.x) == grasp.brake && abs(h.y) == half_chord(grasp);
    return is_corner ? Tangential{h.x, abs(h.y)} : h;
  }
};

struct SwappedCase : PlainClip {
  Tangential slide(const Grasp& grasp) const override {
    const Number s = half_chord(grasp);
    const Number x = abs(grasp.force_on_surface[0]), y = abs(grasp.force_on_surface[1]);
    if (grasp.brake >= grasp.radius || y <= s) return PlainClip::slide(grasp);
    return grasp.brake * x <= y * s ? at_corner(grasp) : on_disc(grasp);
  }
};

struct WheelBand : PlainClip {
  bool sticks(const Grasp& grasp) const override {
    return abs(grasp.force_in_wheel[0]) <= grasp.brake && is_in_disc(grasp);
  }
};

struct WheelPressure : PlainClip {
  Number pressure(const Numbers& force, const Numbers&, const Numbers&) const override {
    return abs(force[2]);
  }
};

struct SignedPressure : PlainClip {
  Number pressure(const Numbers&, const Numbers& on_surface, const Numbers&) const override {
    return on_surface[2];
  }
};

struct LongNormal : PlainClip {
  Number pressure(const Numbers& force, const Numbers&, const Numbers& normal) const override {
    return abs(dot(force, normal));
  }
};

struct TiltedWrongAboutX : PlainClip {
  Axes axes(const Numbers& n) const override { return PlainClip::axes({n[0], -n[1], n[2]}); }
};

struct TiltedWrongAboutY : PlainClip {
  Axes axes(const Numbers& n) const override { return PlainClip::axes({-n[0], n[1], n[2]}); }
};

// X is what of the wheel's x lies in the surface: the same unless the surface tilts about both axes.
struct ProjectedX : PlainClip {
  Axes axes(const Numbers& n) const override {
    const Numbers z = (-1 / length(n)) * n;
    const Numbers level = Numbers{1, 0, 0} - z[0] * z;
    const Numbers x = (1 / length(level)) * level;
    return {x, cross(z, x), z};
  }
};

struct LeftOnSurface : PlainClip {
  Numbers in_wheel(const Axes&, const Numbers& force_on_surface) const override { return force_on_surface; }
};

struct Upside : PlainClip {
  bool is_upright(const Numbers& n, const Number& t) const override {
    return PlainClip::is_upright({n[0], n[1], -abs(n[2])}, t);
  }
};

struct CosineUprightness : PlainClip {
  bool is_upright(const Numbers& n, const Number& t) const override {
    return n[2] < 0 && n[2] * n[2] >= t * t * dot(n, n);
  }
};

struct DefaultUprightness : PlainClip {
  bool is_upright(const Numbers& n, const Number&) const override {
    return PlainClip::is_upright(n, default_min_uprightness);
  }
};

struct OneAxisUprightness : PlainClip {
  bool is_upright(const Numbers& n, const Number& t) const override {
    return PlainClip::is_upright({std::max(abs(n[0]), abs(n[1])), 0, n[2]}, t);
  }
};

}  // namespace

std::vector<Bug> clip_bugs() {
  using enum Reach;
  constexpr Kind clip = Kind::clip;
  return {
      {"radial-clip", clip, common, "every slip is shortened towards the middle", clips<Radial>()},
      {"corner-for-disc", clip, special, "case 3 is taken for case 2", clips<CornerForDisc>()},
      {"band-then-disc", clip, special, "the force is cut to the band, then shortened into the disc",
       clips<BandThenDisc>()},
      {"friction-ellipse", clip, common, "the border is an ellipse", clips<Ellipse>()},
      {"no-band-backwards", clip, special, "the brake band is forgotten for F'_x < 0",
       clips<NoBandBackwards>()},
      {"no-band-unbraked", clip, special, "brake 0 is read as no band at all", clips<NoBandUnbraked>()},
      {"slides-forward", clip, special, "H_x is B whatever the sign of F'_x", clips<ForwardOnly>()},
      {"corner-right", clip, special, "H_y in case 2 is s whatever the sign of F'_y", clips<RightOnly>()},
      {"swapped-case-test", clip, special, "cases 2 and 3 are told apart with x and y swapped",
       clips<SwappedCase>()},
      {"band-in-wheel", clip, special, "the band is tested with F_x", clips<WheelBand>()},
      {"pressure-in-wheel", clip, special, "N is |F_z|", clips<WheelPressure>()},
      {"signed-pressure", clip, special, "N is F'_z with its sign", clips<SignedPressure>()},
      {"long-normal", clip, special, "N is |F.n|, the normal not normalized", clips<LongNormal>()},
      {"tilt-about-x", clip, special, "the surface is tilted the wrong way about x",
       clips<TiltedWrongAboutX>()},
      {"tilt-about-y", clip, special, "the surface is tilted the wrong way about y",
       clips<TiltedWrongAboutY>()},
      {"projected-x", clip, special, "the surface's x is the projection of the wheel's", clips<ProjectedX>()},
      {"left-on-surface", clip, special, "a slip's force is not turned back into the wheel",
       clips<LeftOnSurface>()},
      {"upside-down", clip, special, "a surface that faces down is upright", clips<Upside>()},
      {"cosine-uprightness", clip, special, "uprightness is compared with the whole normal",
       clips<CosineUprightness>()},
      {"default-uprightness", clip, special, "the ask's uprightness is ignored", clips<DefaultUprightness>()},
      {"one-axis-uprightness", clip, special, "steepness is that along the steeper axis",
       clips<OneAxisUprightness>()},
  };
}

}  // namespace groundtruth::planted
