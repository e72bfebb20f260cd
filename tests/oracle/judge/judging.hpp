#pragma once
// What the tests of the judge share.

#include <string_view>

#include <groundtruth/cases/case.hpp>
#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/judge/verdict.hpp>

namespace groundtruth::judge {

inline Answer exact_answer(const Scene& scene, const Ask& ask) {
  return implementations::make_engine("exact")->on(scene)->answer(ask).answer;
}

inline const Tolerance& tolerance_of(std::string_view profile) {
  return find_profile(profile)->tolerance;
}

inline Difference difference(const Scene& scene, const Tolerance& tolerance, const Ask& ask,
                             const Answer& got) {
  return Judge(scene, tolerance).judge(ask, got).difference;
}

// The unit box, dry, with ice on its top where x > 1/2.
inline Scene iced_box() {
  using namespace cases;
  return {ground_materials(),
          painted(icy, half_space(-1, 0, 0, -0.5), covered(dry, box({0, 0, 0}, {1, 1, 1})))};
}

}  // namespace groundtruth::judge
