#include <groundtruth/diagnosis/resemblance.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace groundtruth::diagnosis {
namespace {

using Numbers = std::vector<Vector>;  // each compared by its largest difference

struct Collect {
  Numbers& numbers;
  void operator()(const EntryAnswer& answer) {
    if (const auto* inside = std::get_if<Inside>(&answer)) numbers.push_back({inside->lambda, 0, 0});
    if (const auto* border = std::get_if<Border>(&answer)) numbers.push_back({border->lambda, 0, 0});
  }
  void operator()(const ClipAnswer& answer) {
    if (const auto* clipped = std::get_if<Clipped>(&answer)) numbers.push_back(clipped->force_in_wheel);
  }
  void operator()(const StepAnswer& answer) {
    const auto* stepped = std::get_if<Stepped>(&answer);
    if (stepped == nullptr) return;
    numbers.push_back(stepped->force_on_frame_in_world);
    const auto* contact = std::get_if<Contact>(&stepped->state);
    if (contact == nullptr) return;
    numbers.push_back(contact->pebble_in_world);
    numbers.push_back(contact->pebble_velocity_in_world);
  }
};

Numbers numbers_of(const Answer& answer) {
  Numbers numbers;
  Collect collect{numbers};
  std::visit(collect, answer);
  return numbers;
}

bool same_kind(const EntryAnswer& a, const EntryAnswer& b) {
  if (a.index() != b.index()) return false;
  const auto* x = std::get_if<Border>(&a);
  const auto* y = std::get_if<Border>(&b);
  return x == nullptr ||
         (x->leaf == y->leaf && x->normal_in_world == y->normal_in_world && x->material == y->material);
}

bool same_kind(const ClipAnswer& a, const ClipAnswer& b) {
  if (a.index() != b.index()) return false;
  const auto* x = std::get_if<Clipped>(&a);
  return x == nullptr || x->grip == std::get<Clipped>(b).grip;
}

bool same_kind(const StepAnswer& a, const StepAnswer& b) {
  if (a.index() != b.index()) return false;
  if (const auto* failure = std::get_if<StepFailure>(&a)) return *failure == std::get<StepFailure>(b);
  const auto* stepped = std::get_if<Stepped>(&a);
  if (stepped == nullptr) return true;
  const WheelState& other = std::get<Stepped>(b).state;
  if (stepped->state.index() != other.index()) return false;
  const auto* x = std::get_if<Contact>(&stepped->state);
  const auto* y = std::get_if<Contact>(&other);
  return x == nullptr || (x->grip == y->grip && x->normal_in_world == y->normal_in_world &&
                          x->static_friction == y->static_friction &&
                          x->dynamic_friction == y->dynamic_friction && x->maximum_force == y->maximum_force);
}

bool same_kind(const Answer& a, const Answer& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& answer) { return same_kind(answer, std::get<std::decay_t<decltype(answer)>>(b)); }, a);
}

double difference(const Vector& a, const Vector& b) {
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

double few_ulps(const Vector& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}) * 0x1p-46;
}

}  // namespace

bool shares_error(const Answer& suspected, const Answer& got, const Answer& exact) {
  if (!same_kind(suspected, got)) return false;
  if (!same_kind(exact, got)) return resembles(suspected, got);
  const Numbers a = numbers_of(suspected), b = numbers_of(got), c = numbers_of(exact);
  bool is_right = true;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double error = difference(b[i], c[i]);
    is_right = is_right && difference(a[i], c[i]) == 0;
    if (!(difference(a[i], b[i]) <= std::max(error / 1000, std::min(error / 4, few_ulps(b[i])))))
      return false;
  }
  return !is_right;
}

bool resembles(const Answer& suspected, const Answer& got) {
  if (!same_kind(suspected, got)) return false;
  const Numbers a = numbers_of(suspected), b = numbers_of(got);
  for (std::size_t i = 0; i < b.size(); ++i)
    if (!(difference(a[i], b[i]) <= few_ulps(b[i]))) return false;
  return true;
}

}  // namespace groundtruth::diagnosis
