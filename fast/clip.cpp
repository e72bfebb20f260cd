#include <groundtruth/fast/clip.hpp>

#include <groundtruth/fast/clip_decided.hpp>
#include <groundtruth/fast/exact_stage/clip.hpp>
#include <groundtruth/fast/surface.hpp>

namespace groundtruth::fast {

namespace {

struct Decision {
  bool is_too_steep = false;
  Clipping clipping = Clipping::none;
};

// The ask in counted numbers.
template <class Real>
class CountedClip {
 public:
  explicit CountedClip(const ClipAsk& ask)
      : ask_(ask),
        grasp_{counted<Real>(ask.normal_in_wheel), counted<Real>(ask.friction), counted<Real>(ask.brake)},
        forward_{-grasp_.normal[2], {}, grasp_.normal[0]},
        force_(counted<Real>(ask.force_in_wheel)),
        on_surface_(grasp_, forward_, force_) {}

  std::optional<Decision> decide() const {
    const auto upright = is_upright(grasp_.normal[2], on_surface_.n_squared(), ask_.min_uprightness);
    if (!upright) return std::nullopt;
    if (!*upright) return Decision{true, Clipping::none};
    const auto clipping = on_surface_.decide();
    return clipping ? std::optional(Decision{false, *clipping}) : std::nullopt;
  }

  std::optional<Vector> force(Clipping clipping) const {
    return on_surface_.clipped(clipping, [](const auto& force) { return nearest_doubles(force); });
  }

 private:
  const ClipAsk& ask_;
  const Grasp<Real, 0> grasp_;
  const CountedVector<Real, 0> forward_;
  const CountedVector<Real, 0> force_;
  const ForceOnSurface<Real, 0, 0, 0> on_surface_;
};

GROUNDTRUTH_FLAT std::optional<Decision> decide_in_doubles(const ClipAsk& ask) {
  return CountedClip<double>(ask).decide();
}

GROUNDTRUTH_FUSED std::optional<Vector> fused_force(const ClipAsk& ask, Clipping clipping) {
  return CountedClip<FusedPair>(ask).force(clipping);
}

struct RoundedForce {
  std::optional<Vector> force;  // absent: uncertain
  Stage stage = Stage::exact;
};

RoundedForce rounded_force(const ClipAsk& ask, Clipping clipping, Kernels kernels) {
  if (kernels == Kernels::fused) return {fused_force(ask, clipping), Stage::double_pair};
  if (const auto force = CountedClip<Extended>(ask).force(clipping)) return {force, Stage::extended};
  return {CountedClip<Pair>(ask).force(clipping), Stage::double_pair};
}

// -0 is written 0.
Vector without_signs_of_zeros(const Vector& v) { return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0}; }

}  // namespace

DecidedClip decide_clip(const ClipAsk& ask, Kernels kernels) {
  Stage stage = Stage::doubles;
  auto decision = decide_in_doubles(ask);
  if (!decision) {
    stage = Stage::double_pair;
    decision = CountedClip<Pair>(ask).decide();
  }
  if (!decision) return {exact_stage::clip(ask), Stage::exact, Stage::exact};
  if (decision->is_too_steep) return {TooSteep{}, stage, Stage::none};
  if (decision->clipping == Clipping::none)
    return {Clipped{Grip::stick, without_signs_of_zeros(ask.force_in_wheel)}, stage, Stage::none};
  const RoundedForce rounded = rounded_force(ask, decision->clipping, kernels);
  if (rounded.force) return {Clipped{Grip::slip, *rounded.force}, stage, rounded.stage};
  return {exact_stage::clip(ask), stage, Stage::exact};
}

ClipAnswer clip(const ClipAsk& ask) { return decide_clip(ask).answer; }

}  // namespace groundtruth::fast
