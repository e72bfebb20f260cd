#include <groundtruth/fast/clip.hpp>

#include <groundtruth/fast/clip_decided.hpp>
#include <groundtruth/fast/exact_stage/clip.hpp>
#include <groundtruth/fast/surface.hpp>

namespace groundtruth::fast {

namespace {

template <class Real>
Grasp<Real, 0, 0> grasp_of(const ClipAsk& ask) {
  return {counted<Real>(ask.normal_in_wheel), counted<Real>(ask.friction), counted<Real>(ask.brake)};
}

struct Decision {
  bool is_too_steep = false;
  Clipping clipping = Clipping::none;
};

template <class Real>
std::optional<Decision> decide(const ClipAsk& ask) {
  const auto grasp = grasp_of<Real>(ask);
  const auto upright = is_upright(grasp.normal_in_wheel, ask.min_uprightness);
  if (!upright) return std::nullopt;
  if (!*upright) return Decision{true, Clipping::none};
  const auto clipping = ForceOnSurface(grasp, counted<Real>(ask.force_in_wheel)).decide();
  return clipping ? std::optional(Decision{false, *clipping}) : std::nullopt;
}

template <class Real>
std::optional<Vector> clipped_force(const ClipAsk& ask, Clipping clipping) {
  const auto grasp = grasp_of<Real>(ask);
  return ForceOnSurface(grasp, counted<Real>(ask.force_in_wheel)).clipped(clipping, [](const auto& force) {
    return nearest_doubles(force);
  });
}

// -0 is written 0.
Vector without_signs_of_zeros(const Vector& v) { return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0}; }

}  // namespace

DecidedClip decide_clip(const ClipAsk& ask) {
  Stage stage = Stage::doubles;
  auto decision = decide<double>(ask);
  if (!decision) {
    stage = Stage::double_pair;
    decision = decide<Pair>(ask);
  }
  if (!decision) return {exact_stage::clip(ask), Stage::exact, Stage::exact};
  if (decision->is_too_steep) return {TooSteep{}, stage, Stage::none};
  if (decision->clipping == Clipping::none)
    return {Clipped{Grip::stick, without_signs_of_zeros(ask.force_in_wheel)}, stage, Stage::none};
  if (const auto force = clipped_force<Extended>(ask, decision->clipping))
    return {Clipped{Grip::slip, *force}, stage, Stage::extended};
  if (const auto force = clipped_force<Pair>(ask, decision->clipping))
    return {Clipped{Grip::slip, *force}, stage, Stage::double_pair};
  return {exact_stage::clip(ask), stage, Stage::exact};
}

ClipAnswer clip(const ClipAsk& ask) { return decide_clip(ask).answer; }

}  // namespace groundtruth::fast
