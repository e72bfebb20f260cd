#pragma once
// The last stage of a clip (SPEC section 4): in exact numbers, for any doubles at all. Not installed.

#include <groundtruth/fast/exact_stage/normal.hpp>
#include <groundtruth/fast/exact_stage/surd.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast::exact_stage {

// A vector of such numbers over one denominator > 0.
struct SurdVector {
  std::array<Surd, 3> numerators;
  Dyadic denominator;
  Radicands roots;
};

// The doubles nearest to a vector's components, or which of them leaves the range of doubles
// ("force[1] leaves the range of doubles").
std::variant<Vector, Refusal> nearest_doubles(const SurdVector& v, const char* quantity);

bool is_upright(const Normal<Dyadic>& normal_in_wheel, double min_uprightness);

// What the surface takes a force of `force_in_wheel` / denominator to be clipped by.
struct Grasp {
  Normal<Dyadic> normal_in_wheel;  // any length; upright
  Normal<Dyadic> force_in_wheel;
  Dyadic denominator;  // > 0
  double friction;
  double brake;
};

struct ClippedForce {
  Grip grip;
  SurdVector force_in_wheel;
  Dyadic surplus;  // the result's denominator over the grasp's
};

ClippedForce clip_force(const Grasp& grasp);

// SPEC section 4, every component of the force correctly rounded.
ClipAnswer clip(const ClipAsk& ask);

}  // namespace groundtruth::fast::exact_stage
