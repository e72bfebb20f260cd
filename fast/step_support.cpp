#include <groundtruth/fast/step_support.hpp>

#include <algorithm>
#include <cmath>

#include <groundtruth/fast/number_pair.hpp>

namespace groundtruth::fast {

namespace {

// Products of two such numbers are known as pairs, without rounding.
bool is_zero_or_large(double x) { return x == 0 || std::abs(x) >= 0x1p-200; }

bool have_distinct_products(double a, double b, double c, double d) {
  const double first = a * b, second = c * d;
  if (first != second) return true;
  return first != 0 && SplitProducts::lost(a, b, first) != SplitProducts::lost(c, d, second);
}

// Of a^2 + b^2 and c^2 + d^2. There may be more ways to be equal.
bool may_have_distinct_squares(double a, double b, double c, double d) {
  const auto have_equal_size = [](double x, double y) { return std::abs(x) == std::abs(y); };
  return !(have_equal_size(a, c) && have_equal_size(b, d)) &&
         !(have_equal_size(a, d) && have_equal_size(b, c));
}

}  // namespace

AxesSupport support_of_axes(const Quaternion& q) {
  constexpr Support everywhere{true, true, true};
  if (!std::ranges::all_of(q, is_zero_or_large)) return {everywhere, everywhere};
  const auto [w, x, y, z] = q;
  return {{have_distinct_products(x, y, w, z), may_have_distinct_squares(w, y, x, z),
           have_distinct_products(y, z, -w, x)},
          {have_distinct_products(x, z, -w, y), have_distinct_products(y, z, w, x),
           may_have_distinct_squares(w, z, x, y)}};
}

StepSupport::StepSupport(const StepAsk& ask, const Contact& contact, double friction)
    : relocation(ask.wheel.relocation),
      arm(Support::of_difference(contact.pebble_in_world, ask.frame.position_in_world)) {
  const AxesSupport axes = support_of_axes(ask.frame.world_from_wheel);
  downward = axes.downward;
  velocity = Support::of_difference(contact.pebble_velocity_in_world, ask.frame.velocity_in_world) |
             cross(Support(ask.frame.angular_velocity_in_world), arm);
  const Support normal(contact.normal_in_world);
  surface = {normal, cross(normal, axes.rightward), arm | velocity | downward, friction != 0, ask.brake != 0};
}

Support StepSupport::of_offset(Clipping clipping) const {
  const Support clipped = surface.clipped(clipping);
  return relocation == Relocation::spring ? clipped : clipped | arm | velocity;
}

}  // namespace groundtruth::fast
