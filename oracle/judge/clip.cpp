#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "borders.hpp"
#include "spread.hpp"
#include "uprightness.hpp"
#include "weigh.hpp"
#include "wording.hpp"

namespace groundtruth::judge {
namespace {

// |n . F| / ||n||, from unit vectors, so that no product leaves the range; 0 without a normal.
long double pressing_of(const ClipAsk& ask) {
  const long double size = length(ask.normal_in_wheel);
  if (size == 0) return 0;
  long double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += ask.normal_in_wheel[i] / size * ask.force_in_wheel[i];
  return std::fabs(sum);
}

class ClipWeighing {
 public:
  ClipWeighing(const Truth& truth, const ClipAsk& ask, const ClipAnswer& got, const Answered& exact)
      : truth_(truth), tolerance_(truth.tolerance()), ask_(ask), got_(got), exact_(exact) {}

  Verdict weigh() const {
    const Verdict against_exact = weigh_against(std::get<ClipAnswer>(exact_.answer));
    if (against_exact.is_accepted() || tolerance_.relative_decision == 0) return against_exact;
    if (std::holds_alternative<TooSteep>(got_)) {
      const ClipAnswer strict = answer(with_uprightness(stricter(ask_.min_uprightness, tolerance_)));
      return std::holds_alternative<TooSteep>(strict) ? Verdict{} : against_exact;
    }
    if (const auto* clipped = std::get_if<Clipped>(&got_)) {
      return is_explained_by_a_border_nearby(*clipped) ? Verdict{} : against_exact;
    }
    return against_exact;
  }

 private:
  Verdict weigh_against(const ClipAnswer& expected) const {
    Verdict verdict;
    const bool got_refuses = std::holds_alternative<Refusal>(got_);
    const bool expected_refuses = std::holds_alternative<Refusal>(expected);
    if (got_refuses && expected_refuses) return verdict;
    const auto* got = std::get_if<Clipped>(&got_);
    const auto* right = std::get_if<Clipped>(&expected);
    if (got_.index() != expected.index() || (got && got->grip != right->grip)) {
      verdict.difference = got_refuses || expected_refuses ? Difference::refusal : Difference::stick_slip;
      verdict.explanation = fmt::format("{} -> {}", kind_in_words(got_), kind_in_words(expected));
      return verdict;
    }
    if (got == nullptr) return verdict;
    const long double apart = Spread(right->force_in_wheel).distance_to(got->force_in_wheel);
    if (apart <= allowed(tolerance_.relative_number, scale(right->grip))) return verdict;
    verdict.difference = Difference::numbers;
    verdict.newtons = static_cast<double>(apart);
    verdict.explanation = fmt::format("force {} -> {}: {} N", words(got->force_in_wheel),
                                      words(right->force_in_wheel), short_number(verdict.newtons));
    return verdict;
  }

  // SPEC section 6: stick on the border grown, slip on the border shrunk; the force is that of some border
  // within the change (proofs-notes/tolerance.md, 3).
  bool is_explained_by_a_border_nearby(const Clipped& got) const {
    const long double change = tolerance_.relative_decision * length(ask_.force_in_wheel);
    std::vector<Clipped> nearby;
    for (const BorderNumbers& border :
         borders_around({ask_.friction, ask_.brake}, pressing_of(ask_), change)) {
      ClipAsk ask = with_uprightness(more_lenient(ask_.min_uprightness, tolerance_));
      ask.friction = border.friction;
      ask.brake = border.brake;
      const ClipAnswer on_border = answer(ask);
      const auto* clipped = std::get_if<Clipped>(&on_border);
      if (clipped == nullptr) return false;
      nearby.push_back(*clipped);
    }
    const Clipped& grown = nearby[0];
    const Clipped& shrunk = nearby[1];
    if (got.grip == Grip::stick) {
      return grown.grip == Grip::stick && Spread(grown.force_in_wheel).distance_to(got.force_in_wheel) <=
                                              allowed(tolerance_.relative_number, scale(Grip::stick));
    }
    Spread spread(grown.force_in_wheel);
    for (const Clipped& clipped : nearby) spread.include(clipped.force_in_wheel);
    const long double slack = allowed(tolerance_.relative_number, scale(Grip::slip)) + 4 * change;
    return shrunk.grip == Grip::slip && spread.distance_to(got.force_in_wheel) <= slack;
  }

  // A force that sticks is its own largest term; one that slips has mu times the normal force's terms in it.
  long double scale(Grip grip) const {
    const long double size = length(ask_.force_in_wheel);
    return grip == Grip::stick ? size : size * std::max(1.0, ask_.friction);
  }

  ClipAsk with_uprightness(double min_uprightness) const {
    ClipAsk ask = ask_;
    ask.min_uprightness = min_uprightness;
    return ask;
  }
  ClipAnswer answer(const ClipAsk& ask) const { return std::get<ClipAnswer>(truth_.answer(ask).answer); }

  const Truth& truth_;
  const Tolerance& tolerance_;
  const ClipAsk& ask_;
  const ClipAnswer& got_;
  const Answered& exact_;
};

}  // namespace

Verdict weigh_clip(const Truth& truth, const ClipAsk& ask, const ClipAnswer& got, const Answered& exact) {
  return ClipWeighing(truth, ask, got, exact).weigh();
}

}  // namespace groundtruth::judge
