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
  explicit QuickAxes(const Quaternion& q) : q_(q) {
    const auto [w, x, y, z] = q;
    const Pair ww = Pair::product(w, w), xx = Pair::product(x, x), yy = Pair::product(y, y),
               zz = Pair::product(z, z);
    const Pair upward = Pair::loose_sum(ww, zz), sideward = Pair::loose_sum(xx, yy);
    down_ = {twice(determinant<Pair>(x, z, -w, y)), twice(determinant<Pair>(y, z, w, x)),
             Pair::loose_sum(upward, -sideward).tidy()};
    norm_squared_ = Pair::loose_sum(upward, sideward).tidy();
  }

  const Vector3<Pair>& down() const { return down_; }
  const Pair& norm_squared() const { return norm_squared_; }
  Vector3<Pair> rightward() const {
    const auto [w, x, y, z] = q_;
    const Pair y_axis = Pair::loose_sum(determinant<Pair>(w, w, x, x), determinant<Pair>(y, y, z, z)).tidy();
    return {twice(determinant<Pair>(x, y, w, z)), y_axis, twice(determinant<Pair>(y, z, -w, x))};
  }
  // Within 2^-50 |q|^2.
  Vector rightward_in_doubles() const {
    const auto [w, x, y, z] = q_;
    return {2 * (x * y - w * z), (w * w - x * x) + (y * y - z * z), 2 * (y * z + w * x)};
  }

 private:
  static Pair twice(const Pair& a) { return Pair(2 * a.high, 2 * a.low).tidy(); }

  const Quaternion& q_;
  Vector3<Pair> down_;
  Pair norm_squared_;
};

// Formulas: lemma load-without-rotation, as in Load (step_load.hpp). Errors: lemma load-in-pairs
// (proofs-notes/rounding-of-forces.md, section 10).
template <class Pair>
class QuickLoad {
 public:
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
    const Vector3<Pair> turning = cross<Pair>(spin, arm_);
    for (std::size_t k = 0; k < 3; ++k) velocity_[k] = velocity_[k] - turning[k];
    velocity_size_ += sum_of_magnitudes(spin) * arm_size_;
  }

  const Vector3<Pair>& arm() const { return arm_; }  // from the frame to the pebble
  double arm_size() const { return arm_size_; }
  const Pair& depth() const { return depth_; }  // of the pebble in the wheel, times |q|^2
  const Vector3<Pair>& velocity() const { return velocity_; }
  double velocity_size() const { return velocity_size_; }

  // Within 2^-95 force_size() of the springs' force on the pebble.
  Vector3<Pair> force() const {
    const Wheel& wheel = ask_.wheel;
    const Pair& unit = axes_.norm_squared();
    const Pair springs = product_of<Pair>(Pair::sum(wheel.k_z, -wheel.k_xy), depth_);
    const Pair dampers =
        product_of<Pair>(Pair::sum(wheel.d_z, -wheel.d_xy), dot<Pair>(axes_.down(), velocity_));
    const Pair at_rest = product_of<Pair>(Pair::product(wheel.k_z, wheel.z_zero), unit);
    const Pair along_strut = Pair::loose_sum(Pair::loose_sum(springs, dampers), -at_rest);
    const Pair unit_squared = unit * unit;
    const Pair more = quotient(along_strut, unit_squared, 1 / unit_squared.high);
    const auto axis = [&](std::size_t k) {
      const Pair level =
          Pair::loose_sum(product_of<Pair>(wheel.k_xy, arm_[k]), product_of<Pair>(wheel.d_xy, velocity_[k]));
      return Pair::loose_sum(level, product_of<Pair>(more, axes_.down()[k])).tidy();
    };
    return {axis(0), axis(1), axis(2)};
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
  const Vector3<Pair> arm_;
  const double arm_size_;
  const Pair depth_;
  Vector3<Pair> velocity_;
  double velocity_size_;
};

}  // namespace groundtruth::fast
