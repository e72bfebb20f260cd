#include <groundtruth/validation/circumstances.hpp>

#include <algorithm>
#include <cmath>

namespace groundtruth::validation {
namespace {

// A number made of small ones.
class Mix {
 public:
  void add(std::uint64_t value) { sum_ = (sum_ ^ value) * 0x100000001b3u + 0x9e3779b97f4a7c15u; }
  void add(bool value) { add(std::uint64_t{value}); }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325u;
};

// Powers of 2^10, so that a kilometre and a million of them differ.
std::uint64_t magnitude(const Vector& vector) {
  const double largest = std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
  if (largest == 0) return 0;
  return static_cast<std::uint64_t>(200 + std::ilogb(largest) / 10);
}

std::uint64_t sign_of(double value) { return value > 0 ? 2 : value < 0 ? 1 : 0; }

void add_entry(Mix& mix, const EntryAsk& ask, const EntryAnswer& exact, const Evidence& evidence) {
  mix.add(exact.index());
  mix.add(ask.from == ask.to);
  mix.add(ask.lambda_first == ask.lambda_last);
  mix.add(sign_of(ask.lambda_first) * 3 + sign_of(ask.lambda_last - 1));
  mix.add(magnitude(ask.from));
  if (const auto* border = std::get_if<Border>(&exact)) {
    mix.add(border->lambda == ask.lambda_first);
    mix.add(border->lambda == ask.lambda_last);
    mix.add(std::min<std::uint64_t>(evidence.admissible.size(), 5));
    mix.add(border->material.has_value());
    mix.add(std::min<std::uint64_t>(border->leaf, 8));
  }
}

// The border is about the disc's or the band's: which is told from the doubles, roughly.
void add_clip(Mix& mix, const ClipAsk& ask, const ClipAnswer& exact) {
  mix.add(exact.index());
  const auto* clipped = std::get_if<Clipped>(&exact);
  if (clipped == nullptr) return;
  mix.add(clipped->grip == Grip::slip);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    mix.add(sign_of(ask.force_in_wheel[axis]));
    mix.add(sign_of(ask.normal_in_wheel[axis]));
  }
  mix.add(sign_of(ask.brake - std::abs(ask.friction * ask.force_in_wheel[2])));
  mix.add(clipped->force_in_wheel == ask.force_in_wheel);
}

std::uint64_t number_of(const WheelState& state) {
  const auto* contact = std::get_if<Contact>(&state);
  return contact == nullptr ? 0 : contact->grip == Grip::stick ? 1 : 2;
}

void add_step(Mix& mix, const StepAsk& ask, const StepAnswer& exact) {
  mix.add(number_of(ask.state));
  mix.add(exact.index());
  mix.add(ask.wheel.relocation == Relocation::return_mapping);
  mix.add(ask.frame.angular_velocity_in_world != Vector{});
  mix.add(magnitude(ask.frame.position_in_world));
  mix.add(ask.brake == 0);
  if (const auto* failure = std::get_if<StepFailure>(&exact)) mix.add(static_cast<std::uint64_t>(*failure));
  if (const auto* stepped = std::get_if<Stepped>(&exact)) {
    mix.add(number_of(stepped->state));
    mix.add(stepped->force_on_frame_in_world == Vector{});
  }
}

}  // namespace

std::uint64_t circumstances_of(const Ask& ask, const Finding& finding) {
  Mix mix;
  mix.add(ask.index());
  mix.add(static_cast<std::uint64_t>(finding.outcome));
  mix.add(static_cast<std::uint64_t>(finding.verdict.difference));
  const Answer& exact = finding.verdict.exact;
  if (const auto* entry = std::get_if<EntryAsk>(&ask)) {
    add_entry(mix, *entry, std::get<EntryAnswer>(exact), finding.verdict.evidence);
  } else if (const auto* clip = std::get_if<ClipAsk>(&ask)) {
    add_clip(mix, *clip, std::get<ClipAnswer>(exact));
  } else {
    add_step(mix, std::get<StepAsk>(ask), std::get<StepAnswer>(exact));
  }
  return mix.sum();
}

}  // namespace groundtruth::validation
