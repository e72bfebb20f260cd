#pragma once
// Rotations by quaternions of any length (SPEC section 1), exactly. Not installed.

#include <groundtruth/fast/exact_stage/clip.hpp>

namespace groundtruth::fast::exact_stage {

// All vectors come out longer by |q|^2.
class WorldFromWheel {
 public:
  explicit WorldFromWheel(const Quaternion& q) {
    const Dyadic w(q[0]), x(q[1]), y(q[2]), z(q[3]);
    const Dyadic ww = square(w), xx = square(x), yy = square(y), zz = square(z);
    rows_ = {{{ww + xx - yy - zz, twice(x * y - w * z), twice(x * z + w * y)},
              {twice(x * y + w * z), ww - xx + yy - zz, twice(y * z - w * x)},
              {twice(x * z - w * y), twice(y * z + w * x), ww - xx - yy + zz}}};
    norm_squared_ = ww + xx + yy + zz;
  }

  const Dyadic& norm_squared() const { return norm_squared_; }

  Normal<Dyadic> to_wheel(const Normal<Dyadic>& in_world) const {
    Normal<Dyadic> in_wheel;
    for (std::size_t axis = 0; axis < 3; ++axis)
      in_wheel[axis] =
          rows_[0][axis] * in_world[0] + rows_[1][axis] * in_world[1] + rows_[2][axis] * in_world[2];
    return in_wheel;
  }

  // Of dyadics or surds.
  template <class Number>
  std::array<Number, 3> to_world(const std::array<Number, 3>& in_wheel) const {
    const auto component = [&](const Normal<Dyadic>& row) {
      return in_wheel[0] * row[0] + in_wheel[1] * row[1] + in_wheel[2] * row[2];
    };
    return {component(rows_[0]), component(rows_[1]), component(rows_[2])};
  }

 private:
  static Dyadic twice(const Dyadic& x) { return x.scaled(1); }

  std::array<Normal<Dyadic>, 3> rows_;
  Dyadic norm_squared_;
};

}  // namespace groundtruth::fast::exact_stage
