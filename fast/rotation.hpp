#pragma once
// The axes of a wheel whose orientation is a quaternion of any length (SPEC section 1), in counted numbers.
// Not installed.

#include <groundtruth/fast/surface.hpp>

namespace groundtruth::fast {

// In world coordinates, each of length |q|^2.
template <class Real>
class WheelAxes {
 public:
  explicit WheelAxes(const Quaternion& q)
      : w_(counted<Real>(q[0])), x_(counted<Real>(q[1])), y_(counted<Real>(q[2])), z_(counted<Real>(q[3])) {
    const auto ww = square_of(w_), xx = square_of(x_), yy = square_of(y_), zz = square_of(z_);
    down_ = {twice(x_ * z_ + w_ * y_), twice(y_ * z_ - w_ * x_), (ww + zz) - (xx + yy)};
    rightward_y_ = (ww + yy) - (xx + zz);
    norm_squared_ = (ww + xx) + (yy + zz);
  }

  const CountedVector<Real, 3>& down() const { return down_; }
  CountedVector<Real, 3> rightward() const {
    return {twice(x_ * y_ - w_ * z_), rightward_y_, twice(y_ * z_ + w_ * x_)};
  }
  const Counted<Real, 3>& norm_squared() const { return norm_squared_; }

 private:
  static Counted<Real, 1> square_of(const Counted<Real, 0>& x) { return x * x; }

  const Counted<Real, 0> w_, x_, y_, z_;
  CountedVector<Real, 3> down_;
  Counted<Real, 3> rightward_y_;
  Counted<Real, 3> norm_squared_;
};

}  // namespace groundtruth::fast
