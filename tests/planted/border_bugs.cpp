// Mistakes of the clip on its borders, and with extreme numbers.

#include <cmath>

#include "plain_clip.hpp"

namespace groundtruth::planted {
namespace {

struct OpenBand : PlainClip {
  bool sticks(const Grasp& grasp) const override {
    const Number x = abs(grasp.force_on_surface[0]);
    return PlainClip::sticks(grasp) &&
           compare(x, grasp.brake, length(grasp.force_in_wheel) + grasp.brake) < 0;
  }
};

struct OpenDisc : PlainClip {
  bool sticks(const Grasp& grasp) const override {
    const Numbers& f = grasp.force_on_surface;
    const Number scale = dot(grasp.force_in_wheel, grasp.force_in_wheel) + grasp.radius * grasp.radius;
    return PlainClip::sticks(grasp) &&
           compare(f[0] * f[0] + f[1] * f[1], grasp.radius * grasp.radius, scale) < 0;
  }
};

struct WideBandIsCorner : PlainClip {
  Tangential slide(const Grasp& grasp) const override {
    const bool fits = compare(grasp.brake, abs(grasp.radius)) == 0;
    return fits ? Tangential{with_sign_of(grasp.force_on_surface[0], grasp.brake), 0}
                : PlainClip::slide(grasp);
  }
};

struct Sticky : PlainClip {
  bool sticks(const Grasp& grasp) const override {
    Grasp eased = grasp;
    eased.brake *= Number(1 + 1e-9);
    eased.radius *= Number(1 + 1e-9);
    return PlainClip::sticks(eased);
  }
};

struct NoFrictionSlips : PlainClip {
  bool sticks(const Grasp& grasp) const override { return grasp.radius != 0 && PlainClip::sticks(grasp); }
};

struct SteepnessLimitExcluded : PlainClip {
  bool is_upright(const Numbers& n, const Number& t) const override {
    const Number level = n[0] * n[0] + n[1] * n[1];
    return PlainClip::is_upright(n, t) && compare(n[2] * n[2], t * t * level) > 0;
  }
};

ClipAnswer overflow_sticks(const ClipAsk& ask, const Right& right) {
  const Vector& f = ask.force_in_wheel;
  const ClipAnswer answer = right.clip(ask);
  const bool overflows = std::isinf(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
  return overflows && std::holds_alternative<Clipped>(answer) ? ClipAnswer{Clipped{Grip::stick, f}} : answer;
}

ClipAnswer underflow_sticks(const ClipAsk& ask, const Right& right) {
  const Vector& f = ask.force_in_wheel;
  const ClipAnswer answer = right.clip(ask);
  const bool underflows = f[0] * f[0] + f[1] * f[1] == 0;
  return underflows && std::holds_alternative<Clipped>(answer) ? ClipAnswer{Clipped{Grip::stick, f}} : answer;
}

ClipAsk with_friction_up_to_one(ClipAsk ask) {
  if (ask.friction > 1) ask.friction = 1;
  return ask;
}

ClipAnswer steep_when_it_slips(const ClipAsk& ask, const Right& right) {
  ClipAsk anywhere = ask;
  anywhere.min_uprightness = 0x1p-900;
  const ClipAnswer answer = right.clip(anywhere);
  const auto* clipped = std::get_if<Clipped>(&answer);
  return clipped && clipped->grip == Grip::stick ? answer : right.clip(ask);
}

ClipAnswer force_in_float(const ClipAsk& ask, const Right& right) {
  ClipAnswer answer = right.clip(ask);
  if (auto* clipped = std::get_if<Clipped>(&answer)) {
    for (double& component : clipped->force_in_wheel) {
      if (std::abs(component) < 1e38) component = static_cast<float>(component);
    }
  }
  return answer;
}

}  // namespace

std::vector<Bug> border_bugs() {
  using enum Reach;
  constexpr Kind clip = Kind::clip;
  return {
      {"open-band", clip, tied, "the band's edge slips", clips<OpenBand>()},
      {"open-disc", clip, tied, "the disc's border slips", clips<OpenDisc>()},
      {"wide-band-is-corner", clip, tied, "a slip with B = mu N goes to the band's corner",
       clips<WideBandIsCorner>()},
      {"sticky", clip, tied, "the border is wider by 1e-9", clips<Sticky>()},
      {"no-friction-slips", clip, tied, "where mu N = 0 everything slips, no force too",
       clips<NoFrictionSlips>()},
      {"steepness-limit-excluded", clip, tied, "a surface exactly as steep as allowed is too steep",
       clips<SteepnessLimitExcluded>()},
      {"overflow-sticks", clip, extreme, "the force's square overflows: stick", answers(overflow_sticks)},
      {"underflow-sticks", clip, extreme, "the force's square underflows: stick", answers(underflow_sticks)},
      {"friction-up-to-one", clip, special, "a coefficient above 1 is cut to 1",
       understands(with_friction_up_to_one)},
      {"steep-when-it-slips", clip, special, "steepness is looked at only in a slip",
       answers(steep_when_it_slips)},
      {"force-in-float", clip, common, "the force is answered in float", answers(force_in_float)},
  };
}

}  // namespace groundtruth::planted
