#include <groundtruth/judge/difference.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundtruth::judge {
namespace {

double unit_in_last_place(double value) {
  const double magnitude = std::fabs(value);
  return std::nextafter(magnitude, std::numeric_limits<double>::infinity()) - magnitude;
}

double in_ulps_of(double exact, double error) {
  if (error == 0) return 0;
  return std::min(error / unit_in_last_place(exact), std::numeric_limits<double>::max());
}

double error_in_ulps(double got, double exact) { return in_ulps_of(exact, std::fabs(got - exact)); }

double largest(const Vector& vector) {
  return std::max({std::fabs(vector[0]), std::fabs(vector[1]), std::fabs(vector[2])});
}

double error_in_ulps(const Vector& got, const Vector& exact) {
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::fabs(got[i] - exact[i]));
  return in_ulps_of(largest(exact), worst);
}

class Compare {
 public:
  explicit Compare(Comparison& comparison) : comparison_(comparison) {}

  template <typename Alternatives>
  void answers(const Alternatives& got, const Alternatives& exact, Difference when_kinds_differ) {
    if (got.index() != exact.index()) {
      note(when_kinds_differ);
      return;
    }
    std::visit([&](const auto& value) { same(std::get<std::decay_t<decltype(value)>>(got), value); }, exact);
  }

  void same(const Miss&, const Miss&) {}
  void same(const TooSteep&, const TooSteep&) {}
  void same(const Free&, const Free&) {}
  void same(const Refusal& got, const Refusal& exact) {
    if (got.reason != exact.reason) note(Difference::refusal);
  }
  void same(const Inside& got, const Inside& exact) { lambdas(got.lambda, exact.lambda); }
  void same(const Border& got, const Border& exact) {
    if (got.leaf != exact.leaf || got.normal_in_world != exact.normal_in_world) note(Difference::face);
    if (got.material != exact.material) note(Difference::material);
    lambdas(got.lambda, exact.lambda);
  }
  void same(const Clipped& got, const Clipped& exact) {
    if (got.grip != exact.grip) note(Difference::stick_slip);
    vectors(got.force_in_wheel, exact.force_in_wheel);
  }
  void same(StepFailure got, StepFailure exact) {
    if (got != exact) note(Difference::state);
  }
  void same(const Stepped& got, const Stepped& exact) {
    answers(got.state, exact.state, Difference::state);
    vectors(got.force_on_frame_in_world, exact.force_on_frame_in_world);
  }
  void same(const Contact& got, const Contact& exact) {
    if (got.grip != exact.grip) note(Difference::state);
    if (got.normal_in_world != exact.normal_in_world) note(Difference::face);
    if (got.static_friction != exact.static_friction || got.dynamic_friction != exact.dynamic_friction ||
        got.maximum_force != exact.maximum_force) {
      note(Difference::material);
    }
    vectors(got.pebble_in_world, exact.pebble_in_world);
    vectors(got.pebble_velocity_in_world, exact.pebble_velocity_in_world);
  }

 private:
  void note(Difference difference) {
    if (comparison_.difference == Difference::none) comparison_.difference = difference;
  }
  void lambdas(double got, double exact) {
    comparison_.lambda_ulps = error_in_ulps(got, exact);
    if (got != exact) note(Difference::lambda);
  }
  void vectors(const Vector& got, const Vector& exact) {
    comparison_.vector_ulps = std::max(comparison_.vector_ulps, error_in_ulps(got, exact));
    if (got != exact) note(Difference::numbers);
  }

  Comparison& comparison_;
};

template <typename Alternatives>
bool refuses(const Alternatives& answer) {
  return std::holds_alternative<Refusal>(answer);
}
bool refuses(const EntryAnswer&) { return false; }

Difference when_kinds_differ(const EntryAnswer& got, const EntryAnswer& exact) {
  const bool one_misses = std::holds_alternative<Miss>(got) || std::holds_alternative<Miss>(exact);
  return one_misses ? Difference::hit_miss : Difference::face;
}
Difference when_kinds_differ(const ClipAnswer&, const ClipAnswer&) { return Difference::stick_slip; }
Difference when_kinds_differ(const StepAnswer&, const StepAnswer&) { return Difference::state; }

}  // namespace

std::string_view name_of(Difference difference) {
  constexpr std::array<std::string_view, number_of_differences> names = {
      "none", "refusal", "hit/miss", "face", "material", "stick/slip", "state", "lambda", "numbers"};
  return names[static_cast<std::size_t>(difference)];
}

Comparison compare(const AnswerWithEvidence& got, const AnswerWithEvidence& exact) {
  Comparison comparison;
  std::visit(
      [&](const auto& expected) {
        const auto& answer = std::get<std::decay_t<decltype(expected)>>(got.answer);
        const bool one_refuses = refuses(answer) != refuses(expected);
        Compare(comparison)
            .answers(answer, expected,
                     one_refuses ? Difference::refusal : when_kinds_differ(answer, expected));
      },
      exact.answer);
  if (comparison.difference != Difference::none) return comparison;
  const auto& [lambda, admissible, enclosures] = got.evidence;
  if (!lambda.empty() && lambda != exact.evidence.lambda_exact) comparison.difference = Difference::lambda;
  if (!admissible.empty() && admissible != exact.evidence.admissible)
    comparison.difference = Difference::face;
  return comparison;
}

}  // namespace groundtruth::judge
