#include "wording.hpp"

#include <fmt/format.h>

#include <groundtruth/text/number_text.hpp>

namespace groundtruth::judge {
namespace {

std::string kind(const Miss&) { return "miss"; }
std::string kind(const Inside&) { return "inside"; }
std::string kind(const Border& border) { return fmt::format("border on leaf {}", border.leaf); }
std::string kind(const TooSteep&) { return "too_steep"; }
std::string kind(const Clipped& clipped) { return words(clipped.grip); }
std::string kind(StepFailure failure) { return words(failure); }
std::string kind(const Refusal& refusal) { return fmt::format("error ({})", refusal.reason); }
std::string kind(const Stepped& stepped) {
  const auto* contact = std::get_if<Contact>(&stepped.state);
  return contact == nullptr ? "free" : words(contact->grip);
}

}  // namespace

std::string words(double value) {
  return fmt::format("{} ({})", write_decimal(value), write_hex_float(value));
}

std::string words(const Vector& vector) {
  return fmt::format("[{}, {}, {}]", write_decimal(vector[0]), write_decimal(vector[1]),
                     write_decimal(vector[2]));
}

std::string words(Grip grip) { return grip == Grip::stick ? "stick" : "slip"; }

std::string words(StepFailure failure) {
  switch (failure) {
    case StepFailure::wheel_broken:
      return "wheel_broken";
    case StepFailure::surface_too_steep:
      return "surface_too_steep";
    case StepFailure::surface_gave_way:
      return "surface_gave_way";
  }
  return "unknown";
}

std::string words_of_lambda(const Answered& exact) {
  const auto& entry = std::get<EntryAnswer>(exact.answer);
  const auto* border = std::get_if<Border>(&entry);
  const double lambda = border ? border->lambda : std::get<Inside>(entry).lambda;
  return fmt::format("{} ({})", exact.evidence.lambda_exact, write_hex_float(lambda));
}

std::string words(const MaterialOrNone& material, const Scene& scene) {
  return material && *material < scene.materials.size() ? scene.materials[*material].name : "none";
}

std::string words_of_leaves(const std::vector<Leaf>& leaves) {
  std::string text = "leaf";
  for (std::size_t i = 0; i < leaves.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? " " : " or ", leaves[i]);
  return text;
}

std::string short_number(double value) { return fmt::format("{:.3g}", value); }

std::string kind_in_words(const Answer& answer) {
  return std::visit(
      [](const auto& of_ask) { return std::visit([](const auto& it) { return kind(it); }, of_ask); }, answer);
}

}  // namespace groundtruth::judge
