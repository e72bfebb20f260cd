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

// Decided in doubles, computed in pairs, under one bound. False where something is uncertain; `answer` then
// means nothing.
template <class Pair>
bool give_quickly(const ClipAsk& ask, ClipAnswer& answer) {
  const Vector& n = ask.normal_in_wheel;
  const Vector& force = ask.force_in_wheel;
  const Vector forward{-n[2], 0, n[0]};
  const ForceAsk force_ask{n, forward, force, sum_of_magnitudes(force), ask.friction, ask.brake};
  const SurfaceInDoubles surface(force_ask);
  if (!surface.is_usable(1)) return false;
  const auto upright = is_upright(n[2], surface.n_squared(), ask.min_uprightness);
  if (!upright) return false;
  if (!*upright) {
    answer.emplace<TooSteep>();
    return true;
  }
  const auto support = [&] {
    return SurfaceSupport{Support(n), Support(forward), Support(force), ask.friction != 0, ask.brake != 0};
  };
  const auto clipping = surface.decide(support);
  if (!clipping) return false;
  Clipped& clipped = answer.emplace<Clipped>();
  if (*clipping == Clipping::none) {
    clipped.force_in_wheel = without_signs_of_zeros(force);
    return true;
  }
  clipped.grip = Grip::slip;
  using Doubles = Doubles3<Pair>;
  const auto axis = [&] { return Doubles(forward); };
  const Doubles force_abreast(force);
  const SurfaceInPairs<Pair, Doubles, decltype(axis)> in_pairs(force_ask, axis, force_abreast);
  return round_to_nearest(
      in_pairs.clipped(*clipping), clip_error(force_ask, surface, *clipping),
      [&] { return support().clipped(*clipping); }, clipped.force_in_wheel);
}

GROUNDTRUTH_FUSED bool give_fused(const ClipAsk& ask, ClipAnswer& answer) {
  return give_quickly<FusedPair>(ask, answer);
}
GROUNDTRUTH_FLAT bool give_portable(const ClipAsk& ask, ClipAnswer& answer) {
  return give_quickly<Pair>(ask, answer);
}
bool give_quickly(const ClipAsk& ask, Kernels kernels, ClipAnswer& answer) {
  return kernels == Kernels::fused ? give_fused(ask, answer) : give_portable(ask, answer);
}

bool is_slip(const ClipAnswer& answer) {
  const auto* clipped = std::get_if<Clipped>(&answer);
  return clipped != nullptr && clipped->grip == Grip::slip;
}

DecidedClip clip_in_counted_pairs(const ClipAsk& ask) {
  const CountedClip<Pair> counted(ask);
  const auto decision = counted.decide();
  if (!decision) return {exact_stage::clip(ask), Stage::exact, Stage::exact};
  if (decision->is_too_steep) return {TooSteep{}, Stage::double_pair, Stage::none};
  if (decision->clipping == Clipping::none)
    return {Clipped{Grip::stick, without_signs_of_zeros(ask.force_in_wheel)}, Stage::double_pair,
            Stage::none};
  if (const auto force = counted.force(decision->clipping))
    return {Clipped{Grip::slip, *force}, Stage::double_pair, Stage::double_pair};
  return {exact_stage::clip(ask), Stage::double_pair, Stage::exact};
}

}  // namespace

DecidedClip decide_clip(const ClipAsk& ask, Kernels kernels) {
  DecidedClip quick{{}, Stage::doubles, Stage::none};
  if (!give_quickly(ask, kernels, quick.answer)) return clip_in_counted_pairs(ask);
  if (is_slip(quick.answer)) quick.force = Stage::quick_pair;
  return quick;
}

ClipAnswer clip(const ClipAsk& ask) {
  ClipAnswer answer;
  if (!give_quickly(ask, best_kernels(), answer)) answer = clip_in_counted_pairs(ask).answer;
  return answer;
}

}  // namespace groundtruth::fast
