#pragma once
// Rotations by quaternions of any length (SPEC section 1). Not installed.

#include <groundtruth/fast/number.hpp>

namespace groundtruth::fast {

// v -> q v q^-1, divided by |q|^2 only at the end: where the quaternion is of integers and the result a
// double, nothing is rounded.
template <class Number>
class WorldFromWheel {
 public:
  explicit WorldFromWheel(const Quaternion& q) {
    const Number w(q[0]), x(q[1]), y(q[2]), z(q[3]);
    const Number ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    matrix_ << ww + xx - yy - zz, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
        2 * (x * y + w * z), ww - xx + yy - zz, 2 * (y * z - w * x),         //
        2 * (x * z - w * y), 2 * (y * z + w * x), ww - xx - yy + zz;
    norm_squared_ = ww + xx + yy + zz;
  }

  Vector3<Number> to_world(const Vector3<Number>& in_wheel) const {
    return (matrix_ * in_wheel) / norm_squared_;
  }
  Vector3<Number> to_wheel(const Vector3<Number>& in_world) const {
    return direction_to_wheel(in_world) / norm_squared_;
  }
  // Longer than the original by a positive factor.
  Vector3<Number> direction_to_wheel(const Vector3<Number>& in_world) const {
    return matrix_.transpose() * in_world;
  }

 private:
  Eigen::Matrix<Number, 3, 3> matrix_;  // of the rotation, times norm_squared_
  Number norm_squared_;
};

}  // namespace groundtruth::fast
