#pragma once
// Where a wheel's strut meets the ground, and what contact that makes: the part of SPEC section 5 that making
// contact and slipping on share. Private to this folder.

#include <variant>

#include <groundtruth/exact/solid/entry.hpp>
#include <groundtruth/exact/wheel/motion.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::exact {

// The strut meets nothing, or only its very end touches.
struct Clear {};

struct Landing {
  std::array<RootSum, 3> pebble_in_world;
  Contact contact;  // normal and friction; grip, pebble and its velocity are the caller's to say
};

using Touch = std::variant<Clear, Landing, StepFailure, Refusal>;

// The strut goes from `top_in_world`, where z = z_min, down the wheel's z axis to z_max.
Touch touch_down(const Ground& ground, const Wheel& wheel, const Placement& placement,
                 const RootVector& top_in_world);

}  // namespace groundtruth::exact
