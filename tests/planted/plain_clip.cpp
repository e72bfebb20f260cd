#include "plain_clip.hpp"

#include <cmath>

namespace groundtruth::planted {
namespace {

ClipAnswer answer_of(const PlainClip& clip, const ClipAsk& ask) {
  const Numbers normal = numbers(ask.normal_in_wheel);
  if (!clip.is_upright(normal, ask.min_uprightness)) return TooSteep{};
  const auto outcome = clip.clip(numbers(ask.force_in_wheel), normal, ask.friction, ask.brake);
  return Clipped{outcome.grip, doubles(outcome.force_in_wheel)};
}

}  // namespace

bool PlainClip::is_upright(const Numbers& n, const Number& min_uprightness) const {
  const Number level = n[0] * n[0] + n[1] * n[1];
  return n[2] < 0 && compare(n[2] * n[2], min_uprightness * min_uprightness * level) >= 0;
}

PlainClip::Axes PlainClip::axes(const Numbers& n) const {
  const Number r_squared = n[0] * n[0] + n[2] * n[2];
  const Number r = sqrt(r_squared);
  return {(1 / r) * Numbers{-n[2], 0, n[0]},
          (1 / (r * length(n))) * Numbers{-n[0] * n[1], r_squared, -n[1] * n[2]}, (-1 / length(n)) * n};
}

Number PlainClip::pressure(const Numbers&, const Numbers& force_on_surface, const Numbers&) const {
  return abs(force_on_surface[2]);
}

PlainClip::Outcome PlainClip::clip(const Numbers& force, const Numbers& normal, const Number& friction,
                                   const Number& brake) const {
  const Axes surface = axes(normal);
  const Numbers on_surface{dot(surface.x, force), dot(surface.y, force), dot(surface.z, force)};
  const Grasp grasp{force, on_surface, friction * pressure(force, on_surface, normal), brake};
  if (sticks(grasp)) return {Grip::stick, force};
  const Tangential h = slide(grasp);
  return {Grip::slip, in_wheel(surface, {h.x, h.y, on_surface[2]})};
}

bool PlainClip::is_in_band(const Grasp& grasp) {
  return compare(abs(grasp.force_on_surface[0]), grasp.brake, length(grasp.force_in_wheel) + grasp.brake) <=
         0;
}

bool PlainClip::is_in_disc(const Grasp& grasp) {
  const Numbers& f = grasp.force_on_surface;
  const Number scale = dot(grasp.force_in_wheel, grasp.force_in_wheel) + grasp.radius * grasp.radius;
  return compare(f[0] * f[0] + f[1] * f[1], grasp.radius * grasp.radius, scale) <= 0;
}

bool PlainClip::sticks(const Grasp& grasp) const { return is_in_band(grasp) && is_in_disc(grasp); }

PlainClip::Tangential PlainClip::slide(const Grasp& grasp) const {
  const Numbers& f = grasp.force_on_surface;
  const Number s = half_chord(grasp);
  if (compare(grasp.brake, abs(grasp.radius)) >= 0) return on_disc(grasp);
  if (compare(abs(f[1]), s) <= 0) return {with_sign_of(f[0], grasp.brake), f[1]};
  if (compare(grasp.brake * abs(f[1]), abs(f[0]) * s) <= 0) return at_corner(grasp);
  return on_disc(grasp);
}

Numbers PlainClip::in_wheel(const Axes& surface, const Numbers& f) const {
  return f[0] * surface.x + f[1] * surface.y + f[2] * surface.z;
}

PlainClip::Tangential PlainClip::at_corner(const Grasp& grasp) {
  const Numbers& f = grasp.force_on_surface;
  return {with_sign_of(f[0], grasp.brake), with_sign_of(f[1], half_chord(grasp))};
}

PlainClip::Tangential PlainClip::on_disc(const Grasp& grasp) {
  const Numbers& f = grasp.force_on_surface;
  const Number size = sqrt(f[0] * f[0] + f[1] * f[1]);
  if (size == 0) return {0, 0};
  return {grasp.radius * f[0] / size, grasp.radius * f[1] / size};
}

Number PlainClip::with_sign_of(const Number& signed_number, const Number& size) {
  return signed_number < 0 ? Number(-size) : size;
}

Number PlainClip::half_chord(const Grasp& grasp) {
  const Number squared = grasp.radius * grasp.radius - grasp.brake * grasp.brake;
  return squared > 0 ? Number(sqrt(squared)) : Number(0);
}

ClipAnswer deviation(const Right& right, const ClipAsk& ask, const PlainClip& wrong) {
  const ClipAnswer answer = answer_of(wrong, ask);
  if (answer == answer_of(PlainClip(), ask)) return right.clip(ask);
  const auto* clipped = std::get_if<Clipped>(&answer);
  return clipped && !is_finite(clipped->force_in_wheel) ? right.clip(ask) : answer;
}

bool is_finite(const Vector& vector) {
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

}  // namespace groundtruth::planted
