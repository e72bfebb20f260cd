#include <algorithm>
#include <cmath>
#include <limits>

#include "direction.hpp"
#include "standing.hpp"
#include "step_kinds.hpp"
#include "step_match.hpp"
#include "step_variants.hpp"
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
    if (truth_.tolerance().relative_decision > 0 && is_explained_nearby()) return {};
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

  // By a step whose decisions are each within the tolerance, on the ground as it is, grown or shrunk.
  bool is_explained_nearby() const {
    const auto asks = asks_towards(got_, ask_, match_.scales(), truth_.tolerance());
    const auto explains = [&](const auto& answer) {
      std::vector<StepAnswer> answers;
      for (const StepAsk& ask : asks) answers.push_back(as_asked(std::get<StepAnswer>(answer(ask).answer)));
      return match_.lies_among(got_, answers);
    };
    if (explains([&](const StepAsk& ask) { return truth_.answer(ask); })) return true;
    if (truth_.tolerance().metres == 0) return false;
    return explains([&](const StepAsk& ask) { return truth_.answer_on_grown(ask); }) ||
           explains([&](const StepAsk& ask) { return truth_.answer_on_shrunk(ask); });
  }

  // A pebble that stays keeps its own friction, whatever was asked with.
  StepAnswer as_asked(StepAnswer answer) const {
    auto* stepped = std::get_if<Stepped>(&answer);
    auto* contact = stepped ? std::get_if<Contact>(&stepped->state) : nullptr;
    const auto* before = std::get_if<Contact>(&ask_.state);
    if (contact && before && contact->grip == Grip::stick) {
      contact->static_friction = before->static_friction;
      contact->dynamic_friction = before->dynamic_friction;
      contact->maximum_force = before->maximum_force;
    }
    return answer;
  }

  // The leaves at the place where the strut lands that could make the answer what it is. None where the
  // outcome does not depend on the face.
  std::vector<Leaf> other_faces() const {
    const Contact* contact = contact_in(got_);
    const auto* failure = std::get_if<StepFailure>(&got_);
    const bool depends = contact != nullptr || std::holds_alternative<Refusal>(got_) ||
                         (failure != nullptr && *failure == StepFailure::surface_too_steep);
    const std::optional<Vector> place = depends ? landing_place() : std::nullopt;
    if (!place) return {};
    std::vector<Leaf> faces = leaves_that_may_stand(truth_.scene().shape, *place);
    std::erase_if(faces, [&](Leaf leaf) {
      return contact != nullptr && !points_along(contact->normal_in_world, truth_.leaves()[leaf].normal,
                                                 truth_.tolerance().normal_angle);
    });
    return faces;
  }

  // Where the strut lands, whatever the face: on a ground where every face takes a contact.
  std::optional<Vector> landing_place() const {
    StepAsk ask = ask_;
    ask.wheel.min_uprightness = std::numeric_limits<double>::denorm_min();
    const Answered landed = truth_.answer_on_plain_ground(ask.wheel.tyre, ask);
    const Contact* contact = contact_in(std::get<StepAnswer>(landed.answer));
    if (contact == nullptr) return std::nullopt;
    return contact->pebble_in_world;
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
