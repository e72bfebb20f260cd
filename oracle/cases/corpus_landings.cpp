// A wheel that touches down (SPEC section 5, from free).

#include "corpus_steps.hpp"

namespace groundtruth::cases {

std::vector<Case> corpus_of_landings() {
  const Scene flat = flat_ground();
  const auto touching = [](double height) { return step_at(height, Free{}); };
  StepAsk metal = touching(0.5);
  metal.wheel.tyre = "wood";
  StepAsk long_strut = touching(0.75);
  long_strut.wheel.z_max = 1;
  StepAsk scaled = touching(0.5);
  scaled.frame.world_from_wheel = {0, 3, 0, 0};
  StepAsk leaning = touching(0.375);
  leaning.frame.world_from_wheel = {0, 2, 0, 1};
  const Shape slope = half_space(8, 0, 1, 0);
  return {
      {"landing/misses", flat, touching(1), {"lift-off"}, "The strut ends above the ground: free."},
      {"landing/sticks", flat, touching(0.5), {"border"}, "Touches down: stick, no force yet, no velocity."},
      {"landing/end-of-strut",
       flat,
       touching(0.75),
       {"lift-off", "border"},
       "lambda = 1 exactly: still free."},
      {"landing/one-ulp-nearer",
       flat,
       touching(0x1.7ffffffffffffp-1),
       {"lift-off", "one-ulp"},
       "One ulp lower: stick."},
      {"landing/top-of-strut", flat, touching(0.25), {"broken", "border"}, "lambda = 0 exactly: broken."},
      {"landing/under-ground", flat, touching(-3), {"broken", "inside"}, "Starts inside: broken."},
      {"landing/beyond-z-zero",
       flat,
       long_strut,
       {"border"},
       "Between z_zero and z_max: stick all the same."},
      {"landing/steep-slope",
       ground(slope),
       touching(0.5),
       {"steep"},
       "A slope of 8 in 1 is fine for t = 0.1."},
      {"landing/wall",
       ground(half_space(16, 0, 1, 0)),
       touching(0.5),
       {"steep"},
       "A slope of 16 in 1 is too steep."},
      {"landing/no-material",
       {ground_materials(), half_space(0, 0, 1, 0)},
       touching(0.5),
       {"refusal"},
       "A face without a material: refused, by leaf."},
      {"landing/no-friction", flat, metal, {"refusal"}, "A tyre that no material knows: refused."},
      {"landing/too-steep-before-refused",
       {ground_materials(), half_space(16, 0, 1, 0)},
       touching(0.5),
       {"refusal", "steep"},
       "Too steep and without a material: steepness is looked at first."},
      {"landing/long-quaternion",
       flat,
       scaled,
       {"orientation"},
       "A quaternion of length 3 turns like one of length 1."},
      {"landing/leaning",
       flat,
       leaning,
       {"orientation"},
       "A wheel that leans: the strut is longer than the height."},
      {"landing/seam-of-two-slopes",
       ground(union_of({half_space(1, 0, 4, 0), half_space(-1, 0, 4, 0)})),
       touching(0.5),
       {"seam", "edge"},
       "Lands in a valley's bottom: either slope's normal will do."},
      {"landing/ridge",
       ground(intersection_of({half_space(1, 0, 4, 0), half_space(-1, 0, 4, 0)})),
       touching(0.5),
       {"edge"},
       "Lands on a ridge: either slope's normal will do."},
      {"landing/seam-of-two-materials",
       {ground_materials(),
        union_of({covered(icy, box({-1, -1, -1}, {0, 1, 0})), covered(dry, box({0, -1, -1}, {1, 1, 0}))})},
       touching(0.5),
       {"seam", "paint"},
       "Lands where two materials meet: the friction of either."},
  };
}

}  // namespace groundtruth::cases
