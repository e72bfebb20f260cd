#include <algorithm>
#include <cmath>
#include <limits>

#include "direction.hpp"
#include "step_match.hpp"
#include "weigh.hpp"

namespace groundtruth::judge {
namespace {

class StepWeighing {
 public:
  StepWeighing(const Truth& truth, const StepAsk& ask, const StepAnswer& got, const Answered& exact)
      : truth_(truth), ask_(ask), got_(got), exact_(exact), match_(truth, ask) {}

  Verdict weigh() const {
    Verdict against_exact = match_.against(got_, std::get<StepAnswer>(exact_.answer));
    if (against_exact.is_accepted()) return against_exact;
    if (truth_.tolerance().faces == Faces::any_admissible && is_explained_by_another_face()) return {};
    return against_exact;
  }

 private:
  // SPEC section 6: a step is judged for each admissible leaf.
  bool is_explained_by_another_face() const {
    for (const Leaf leaf : other_faces()) {
      const Answered other = truth_.answer_with_leaf_first(leaf, ask_);
      if (match_.against(got_, std::get<StepAnswer>(other.answer)).is_accepted()) return true;
    }
    return false;
  }

  // The leaves at the place where the strut lands that could make the answer what it is. None where the
  // outcome does not depend on the face.
  std::vector<Leaf> other_faces() const {
    const auto* stepped = std::get_if<Stepped>(&got_);
    const Contact* contact = stepped == nullptr ? nullptr : std::get_if<Contact>(&stepped->state);
    const auto* failure = std::get_if<StepFailure>(&got_);
    const bool depends = contact != nullptr || std::holds_alternative<Refusal>(got_) ||
                         (failure != nullptr && *failure == StepFailure::surface_too_steep);
    const std::optional<Vector> place = depends ? landing_place() : std::nullopt;
    std::vector<Leaf> faces;
    for (Leaf leaf = 0; place && leaf < truth_.leaves().size(); ++leaf) {
      const HalfSpace& plane = truth_.leaves()[leaf];
      const bool named = contact == nullptr || points_along(contact->normal_in_world, plane.normal,
                                                            truth_.tolerance().normal_angle);
      if (named && may_contain(plane, *place)) faces.push_back(leaf);
    }
    return faces;
  }

  // Where the strut lands, whatever the face: on a ground where every face takes a contact.
  std::optional<Vector> landing_place() const {
    StepAsk ask = ask_;
    ask.wheel.min_uprightness = std::numeric_limits<double>::denorm_min();
    const Answered landed = truth_.answer_on_plain_ground(ask.wheel.tyre, ask);
    const auto* stepped = std::get_if<Stepped>(&std::get<StepAnswer>(landed.answer));
    const Contact* contact = stepped == nullptr ? nullptr : std::get_if<Contact>(&stepped->state);
    if (contact == nullptr) return std::nullopt;
    return contact->pebble_in_world;
  }

  // Only a sieve: the exact engine decides whether the leaf is admissible. The place is rounded to doubles.
  static bool may_contain(const HalfSpace& plane, const Vector& place) {
    long double height = -static_cast<long double>(plane.offset);
    long double terms = std::fabs(height);
    for (std::size_t i = 0; i < 3; ++i) {
      const long double term = static_cast<long double>(plane.normal[i]) * place[i];
      height += term;
      terms += std::fabs(term) + std::fabs(plane.normal[i]) * 0x1p-1070L;
    }
    return std::fabs(height) <= 1e-15L * terms;
  }

  const Truth& truth_;
  const StepAsk& ask_;
  const StepAnswer& got_;
  const Answered& exact_;
  StepMatch match_;
};

}  // namespace

Verdict weigh_step(const Truth& truth, const StepAsk& ask, const StepAnswer& got, const Answered& exact) {
  return StepWeighing(truth, ask, got, exact).weigh();
}

}  // namespace groundtruth::judge
