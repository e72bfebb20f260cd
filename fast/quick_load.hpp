#pragma once
// A wheel in contact, and the force of its springs, in double-double under one bound for the ask (SPEC
// section 5). Not installed.

#include <groundtruth/fast/surface_in_pairs.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::fast {

// In world coordinates, each of length |q|^2 and within 2^-99 of that.
template <class Pair>
class QuickAxes {
 public:
  using Pairs = Pairs3<Pair>;
  using Doubles = Doubles3<Pair>;

  explicit QuickAxes(const Quaternion& q) : q_(q) {
    const auto [w, x, y, z] = q;
    const Pair sideward = Pair::loose_sum(Pair::product(x, x), Pair::product(y, y));
    const Pairs sums = sums_of_products(z, {y, -x, w});
    down_ = axis_of(sums, {2, 2, 1}, {{0, 0, -sideward.high}, {0, 0, -sideward.low}});
    norm_squared_ = Pair::loose_sum(component<Pair>(sums, 2), sideward).tidy();
  }

  const Pairs& down() const { return down_; }
  const Pair& norm_squared() const { return norm_squared_; }
  Pairs rightward() const {
    const auto [w, x, y, z] = q_;
    const Pair aside = Pair::loose_sum(Pair::product(x, x), Pair::product(z, z));
    return axis_of(sums_of_products(y, {-z, w, x}), {2, 1, 2}, {{0, -aside.high, 0}, {0, -aside.low, 0}});
  }
  // Within 2^-50 |q|^2.
  Vector rightward_in_doubles() const {
    const auto [w, x, y, z] = q_;
    return {2 * (x * y - w * z), (w * w - x * x) + (y * y - z * z), 2 * (y * z + w * x)};
  }

 private:
  // Of the quaternion's vector with `own`, and of `others` with its scalar.
  Pairs sums_of_products(double own, const Doubles& others) const {
    const auto [w, x, y, z] = q_;
    return Pairs::loose_sum(Pairs::product({x, y, z}, own), Pairs::product(others, w));
  }
  // scale: 1 or 2.
  static Pairs axis_of(const Pairs& sums, const Doubles& scale, const Pairs& more) {
    return Pairs::loose_sum({scale * sums.high, scale * sums.low}, more).tidy();
  }

  const Quaternion& q_;
  Pairs down_;
  Pair norm_squared_;
};

// Formulas: lemma load-without-rotation, as in Load (step_load.hpp). Errors: lemma load-in-pairs
// (proofs-notes/rounding-of-forces.md, section 10).
template <class Pair>
class QuickLoad {
 public:
  using Pairs = Pairs3<Pair>;

  QuickLoad(const StepAsk& ask, const Contact& contact, const QuickAxes<Pair>& axes)
      : ask_(ask),
        axes_(axes),
        arm_(exact_differences<Pair>(contact.pebble_in_world, ask.frame.position_in_world)),
        arm_size_(sum_of_magnitudes(highs_of(arm_))),
        depth_(dot<Pair>(axes.down(), arm_)),
        velocity_(exact_differences<Pair>(contact.pebble_velocity_in_world, ask.frame.velocity_in_world)),
        velocity_size_(sum_of_magnitudes(highs_of(velocity_))) {
    const Vector& spin = ask.frame.angular_velocity_in_world;
    if (spin == Vector{}) return;
    velocity_ = velocity_ - cross<Pair>(Doubles3<Pair>(spin), arm_);
    velocity_size_ += sum_of_magnitudes(spin) * arm_size_;
  }

  const Pairs& arm() const { return arm_; }  // from the frame to the pebble
  double arm_size() const { return arm_size_; }
  const Pair& depth() const { return depth_; }  // of the pebble in the wheel, times |q|^2
  const Pairs& velocity() const { return velocity_; }
  double velocity_size() const { return velocity_size_; }

  // Within 2^-95 force_size() of the springs' force on the pebble.
  Pairs force() const {
    const Wheel& wheel = ask_.wheel;
    const Pair& unit = axes_.norm_squared();
    const Pair springs = product_of<Pair>(Pair::sum(wheel.k_z, -wheel.k_xy), depth_);
    const Pair dampers =
        product_of<Pair>(Pair::sum(wheel.d_z, -wheel.d_xy), dot<Pair>(axes_.down(), velocity_));
    const Pair at_rest = product_of<Pair>(Pair::product(wheel.k_z, wheel.z_zero), unit);
    const Pair along_strut = Pair::loose_sum(Pair::loose_sum(springs, dampers), -at_rest);
    const Pair unit_squared = unit * unit;
    const Pair more = quotient(along_strut, unit_squared, 1 / unit_squared.high);
    const Pairs level =
        Pairs::loose_sum(product_of<Pairs>(wheel.k_xy, arm_), product_of<Pairs>(wheel.d_xy, velocity_));
    return Pairs::loose_sum(level, product_of<Pairs>(more, axes_.down())).tidy();
  }
  double force_size() const {
    const Wheel& wheel = ask_.wheel;
    return (2 * std::abs(wheel.k_xy) + std::abs(wheel.k_z)) * arm_size_ +
           (2 * std::abs(wheel.d_xy) + std::abs(wheel.d_z)) * velocity_size_ +
           std::abs(wheel.k_z * wheel.z_zero);
  }

 private:
  const StepAsk& ask_;
  const QuickAxes<Pair>& axes_;
  const Pairs arm_;
  const double arm_size_;
  const Pair depth_;
  Pairs velocity_;
  double velocity_size_;
};

}  // namespace groundtruth::fast
