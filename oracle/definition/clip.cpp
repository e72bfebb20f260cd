#include <groundtruth/definition/clip.hpp>
#include <groundtruth/definition/force_clip.hpp>
#include <groundtruth/definition/refused.hpp>

namespace groundtruth::definition {

ClipAnswer clip(const ClipAsk& ask) {
  const Triple<Rational> normal_in_wheel = rational(ask.normal_in_wheel);
  if (is_too_steep(normal_in_wheel, rational(ask.min_uprightness))) return TooSteep{};
  const ClippedForce result = clipped(rational(ask.force_in_wheel), Surface(normal_in_wheel),
                                      rational(ask.friction), rational(ask.brake));
  try {
    return Clipped{result.grip, rounded(result.force_in_wheel, "force")};
  } catch (const Refused& refused) {
    return Refusal{refused.what()};
  }
}

}  // namespace groundtruth::definition
