#pragma once
// Plain numbers of the contract (SPEC section 1). Every double here is finite: readers refuse NaN and
// infinities, and every engine may rely on that.

#include <array>

namespace groundtruth {

// A vector or point in the frame that the bearer's name says (`..._in_world`, `..._in_wheel`).
using Vector = std::array<double, 3>;

// Hamilton's [w, x, y, z]. Not necessarily of unit length: the rotation it stands for is v -> q v q^-1,
// so that every matrix entry is a rational function of the four numbers. Never zero.
using Quaternion = std::array<double, 4>;

}  // namespace groundtruth
