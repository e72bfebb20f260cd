#include <groundtruth/fast/clip.hpp>

#include <groundtruth/fast/clip_decided.hpp>
#include <groundtruth/fast/exact_stage/clip.hpp>
#include <groundtruth/fast/surface.hpp>
#include <groundtruth/fast/surface_in_pairs.hpp>

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

// -0 is written 0.
Vector without_signs_of_zeros(const Vector& v) { return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0}; }

DecidedClip stuck(const ClipAsk& ask, Stage stage) {
  return {Clipped{Grip::stick, without_signs_of_zeros(ask.force_in_wheel)}, stage, Stage::none};
}

// Decided in doubles, computed in pairs, under one bound.
template <class Pair>
std::optional<DecidedClip> quick_clip(const ClipAsk& ask) {
  const Vector& n = ask.normal_in_wheel;
  const ForceAsk force_ask{n,           {-n[2], 0, n[0]}, ask.force_in_wheel, sum_of_magnitudes(ask.force_in_wheel),
                           ask.friction, ask.brake};
  const SurfaceInDoubles surface(force_ask);
  if (!surface.is_usable(1)) return std::nullopt;
  const auto upright = is_upright(n[2], surface.n_squared(), ask.min_uprightness);
  if (!upright) return std::nullopt;
  if (!*upright) return DecidedClip{TooSteep{}, Stage::doubles, Stage::none};
  const auto clipping = surface.decide();
  if (!clipping) return std::nullopt;
  if (*clipping == Clipping::none) return stuck(ask, Stage::doubles);
  const auto forward = [&] { return force_ask.forward; };
  const SurfaceInPairs<Pair, double, decltype(forward)> in_pairs(force_ask, forward, force_ask.force);
  Clipped clipped{Grip::slip, {}};
  const double error = clip_error(force_ask, surface, *clipping);
  if (!round_to_nearest(in_pairs.clipped(*clipping), error, clipped.force_in_wheel)) return std::nullopt;
  return DecidedClip{clipped, Stage::doubles, Stage::quick_pair};
}

GROUNDTRUTH_FUSED std::optional<DecidedClip> fused_quick_clip(const ClipAsk& ask) {
  return quick_clip<FusedPair>(ask);
}
GROUNDTRUTH_FLAT std::optional<DecidedClip> portable_quick_clip(const ClipAsk& ask) {
  return quick_clip<Pair>(ask);
}

DecidedClip clip_in_counted_pairs(const ClipAsk& ask) {
  const CountedClip<Pair> counted(ask);
  const auto decision = counted.decide();
  if (!decision) return {exact_stage::clip(ask), Stage::exact, Stage::exact};
  if (decision->is_too_steep) return {TooSteep{}, Stage::double_pair, Stage::none};
  if (decision->clipping == Clipping::none) return stuck(ask, Stage::double_pair);
  if (const auto force = counted.force(decision->clipping))
    return {Clipped{Grip::slip, *force}, Stage::double_pair, Stage::double_pair};
  return {exact_stage::clip(ask), Stage::double_pair, Stage::exact};
}

}  // namespace

DecidedClip decide_clip(const ClipAsk& ask, Kernels kernels) {
  const auto quick = kernels == Kernels::fused ? fused_quick_clip(ask) : portable_quick_clip(ask);
  return quick ? *quick : clip_in_counted_pairs(ask);
}

ClipAnswer clip(const ClipAsk& ask) { return decide_clip(ask).answer; }

}  // namespace groundtruth::fast
