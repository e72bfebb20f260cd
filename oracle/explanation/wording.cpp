#include "wording.hpp"

#include <fmt/format.h>

#include <groundtruth/text/number_text.hpp>

namespace groundtruth::explanation {
namespace {

std::string written(const Vector& v) {
  return fmt::format("({}, {}, {})", write_decimal(v[0]), write_decimal(v[1]), write_decimal(v[2]));
}

class Words {
 public:
  Words(const Evidence& evidence, const Scene& scene) : evidence_(evidence), scene_(scene) {}

  std::string operator()(const Miss&) const {
    return "The segment misses the solid: no point of its range lies in it.";
  }
  std::string operator()(const Inside&) const {
    return "The segment starts inside the solid; no face is met there.";
  }
  std::string operator()(const Border& border) const {
    std::string text = fmt::format(
        "The segment meets the solid at lambda = {}, on leaf {}",
        evidence_.lambda_exact.size() > 60 ? write_decimal(border.lambda) : evidence_.lambda_exact,
        border.leaf);
    if (border.material) text += fmt::format(", of {}", scene_.materials[*border.material].name);
    if (evidence_.admissible.size() > 1)
      text += fmt::format("; {} leaves may be named there", evidence_.admissible.size());
    return text + ".";
  }
  std::string operator()(const TooSteep&) const { return "The surface is too steep for this wheel."; }
  std::string operator()(const Clipped& clipped) const {
    return clipped.grip == Grip::stick
               ? "Stick: the force stays within the border and is unchanged."
               : fmt::format("Slip: the force leaves the border and is cut back to {} N.",
                             written(clipped.force_in_wheel));
  }
  std::string operator()(StepFailure failure) const {
    switch (failure) {
      case StepFailure::wheel_broken:
        return "The wheel is broken: its strut is used up.";
      case StepFailure::surface_too_steep:
        return "The surface is too steep for this wheel.";
      default:
        return "The surface gave way: it is pressed with more than it bears.";
    }
  }
  std::string operator()(const Refusal& refusal) const { return "Refused: " + refusal.reason + "."; }
  std::string operator()(const Stepped& stepped) const {
    const auto* contact = std::get_if<Contact>(&stepped.state);
    const std::string force = written(stepped.force_on_frame_in_world);
    if (contact == nullptr)
      return fmt::format("The wheel is free after the step; force on the frame {} N.", force);
    return fmt::format("The wheel {} after the step, its pebble at {}; force on the frame {} N.",
                       contact->grip == Grip::stick ? "sticks" : "slips", written(contact->pebble_in_world),
                       force);
  }

 private:
  const Evidence& evidence_;
  const Scene& scene_;
};

}  // namespace

std::string in_words(const Answer& answer, const Evidence& evidence, const Scene& scene) {
  const Words words(evidence, scene);
  return std::visit([&](const auto& kind) { return std::visit(words, kind); }, answer);
}

std::string end_in_words(const StepAnswer& answer) {
  if (std::holds_alternative<Refusal>(answer)) return "refused";
  if (const auto* failure = std::get_if<StepFailure>(&answer)) {
    if (*failure == StepFailure::wheel_broken) return "wheel broken";
    return *failure == StepFailure::surface_too_steep ? "surface too steep" : "surface gave way";
  }
  const auto* contact = std::get_if<Contact>(&std::get<Stepped>(answer).state);
  if (contact == nullptr) return "free";
  return contact->grip == Grip::stick ? "stick" : "slip";
}

}  // namespace groundtruth::explanation
