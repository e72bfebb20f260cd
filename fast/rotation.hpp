#pragma once
// Rotations by quaternions of any length (SPEC section 1), in counted numbers. Not installed.

#include <groundtruth/fast/surface.hpp>

namespace groundtruth::fast {

// Vectors come out longer by |q|^2.
template <class Real>
class WorldFromWheel {
 public:
  explicit WorldFromWheel(const Quaternion& q) {
    const auto w = counted<Real>(q[0]), x = counted<Real>(q[1]), y = counted<Real>(q[2]),
               z = counted<Real>(q[3]);
    const auto ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    rows_ = {{{(ww + xx) - (yy + zz), twice(x * y - w * z), twice(x * z + w * y)},
              {twice(x * y + w * z), (ww + yy) - (xx + zz), twice(y * z - w * x)},
              {twice(x * z - w * y), twice(y * z + w * x), (ww + zz) - (xx + yy)}}};
    norm_squared_ = (ww + xx) + (yy + zz);
  }

  const Counted<Real, 3>& norm_squared() const { return norm_squared_; }

  template <int n>
  auto to_world(const CountedVector<Real, n>& in_wheel) const {
    return CountedVector<Real, n + 6>{dot(rows_[0], in_wheel), dot(rows_[1], in_wheel),
                                      dot(rows_[2], in_wheel)};
  }
  template <int n>
  auto to_wheel(const CountedVector<Real, n>& in_world) const {
    const auto component = [&](std::size_t axis) {
      return rows_[0][axis] * in_world[0] + rows_[1][axis] * in_world[1] + rows_[2][axis] * in_world[2];
    };
    return CountedVector<Real, n + 6>{component(0), component(1), component(2)};
  }

 private:
  std::array<CountedVector<Real, 3>, 3> rows_;
  Counted<Real, 3> norm_squared_;
};

}  // namespace groundtruth::fast
