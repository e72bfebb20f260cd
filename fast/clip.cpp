#include <groundtruth/fast/clip.hpp>

#include <groundtruth/fast/clip_decided.hpp>
#include <groundtruth/fast/exact_stage/clip.hpp>
#include <groundtruth/fast/surface.hpp>

namespace groundtruth::fast {

namespace {

template <class Real>
std::optional<ClipAnswer> try_clip(const ClipAsk& ask) {
  const Grasp<Real, 0, 0> grasp{counted<Real>(ask.normal_in_wheel), counted<Real>(ask.friction),
                                counted<Real>(ask.brake)};
  const auto upright = is_upright(grasp.normal_in_wheel, ask.min_uprightness);
  if (!upright) return std::nullopt;
  if (!*upright) return TooSteep{};
  const CountedVector<Real, 0> force = counted<Real>(ask.force_in_wheel);
  return ForceOnSurface(grasp, force).clip([](Grip grip, const auto& clipped) -> std::optional<ClipAnswer> {
    const auto rounded = nearest_doubles(clipped);
    if (!rounded) return std::nullopt;
    return Clipped{grip, *rounded};
  });
}

}  // namespace

DecidedClip decide_clip(const ClipAsk& ask) {
  if (const auto answer = try_clip<Extended>(ask)) return {*answer, Stage::extended};
  if (const auto answer = try_clip<Pair>(ask)) return {*answer, Stage::double_pair};
  return {exact_stage::clip(ask), Stage::exact};
}

ClipAnswer clip(const ClipAsk& ask) { return decide_clip(ask).answer; }

}  // namespace groundtruth::fast
