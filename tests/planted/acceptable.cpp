#include "acceptable.hpp"

#include <algorithm>

#include <groundtruth/judge/difference.hpp>

#include "meeting.hpp"

namespace groundtruth::planted {
namespace {

using judge::Difference;

constexpr double allowed_ulps = 2;

bool is_acceptable(const Border& got, const Border& exact, const EntryAsk& ask, const Right& right) {
  const Meeting meeting(right, ask, exact);
  const Answer got_answer = EntryAnswer{got}, exact_answer = EntryAnswer{exact};
  const double ulps = judge::compare({got_answer, {}}, {exact_answer, {}}).lambda_ulps;
  if (ulps > allowed_ulps || !meeting.is_admissible(got.leaf)) return false;
  const Border there = meeting.on(got.leaf);
  return got.normal_in_world == there.normal_in_world && got.material == there.material;
}

bool has_friction_of(const Contact& contact, const Material& material, const std::string& tyre) {
  const auto friction = material.friction_by_tyre.find(tyre);
  return friction != material.friction_by_tyre.end() &&
         contact.static_friction == friction->second.static_coefficient &&
         contact.dynamic_friction == friction->second.dynamic_coefficient &&
         contact.maximum_force == material.maximum_force;
}

// Does any face near the pebble explain the contact's normal and material?
bool is_explained(const Contact& got, const StepAsk& ask, const Right& right) {
  const Numbers pebble = numbers(got.pebble_in_world);
  return std::any_of(right.leaves().begin(), right.leaves().end(), [&](const PlacedLeaf& leaf) {
    const Numbers normal = numbers(leaf.half_space.normal);
    if (leaf.half_space.normal != got.normal_in_world) return false;
    const Number distance = abs(dot(normal, pebble) - leaf.half_space.offset);
    if (distance > Number(1e-9) * (length(normal) * length(pebble) + abs(Number(leaf.half_space.offset))))
      return false;
    const auto material = material_of(leaf, pebble);
    return material && has_friction_of(got, right.scene().materials[*material], ask.wheel.tyre);
  });
}

const Contact* contact_of(const Answer& answer) {
  const auto* step = std::get_if<StepAnswer>(&answer);
  const auto* stepped = step ? std::get_if<Stepped>(step) : nullptr;
  return stepped ? std::get_if<Contact>(&stepped->state) : nullptr;
}

}  // namespace

bool is_acceptable(const Answer& got, const implementations::Answered& exact, const Ask& ask,
                   const Right& right) {
  const judge::Comparison comparison = judge::compare({got, {}}, {exact.answer, exact.evidence});
  switch (comparison.difference) {
    case Difference::none:
      return true;
    case Difference::lambda:
      return comparison.lambda_ulps <= allowed_ulps;
    case Difference::numbers:
      return comparison.vector_ulps <= allowed_ulps;
    default:
      break;
  }
  if (const auto* entry = std::get_if<EntryAsk>(&ask)) {
    const auto* border = std::get_if<Border>(&std::get<EntryAnswer>(got));
    const auto* expected = std::get_if<Border>(&std::get<EntryAnswer>(exact.answer));
    return border && expected && is_acceptable(*border, *expected, *entry, right);
  }
  const bool may_be_other_face =
      comparison.difference == Difference::face || comparison.difference == Difference::material;
  const Contact* contact = contact_of(got);
  return may_be_other_face && contact && is_explained(*contact, std::get<StepAsk>(ask), right);
}

}  // namespace groundtruth::planted
