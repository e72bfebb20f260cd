// A pebble that slips (SPEC section 5).

#include "corpus_steps.hpp"

namespace groundtruth::cases {
namespace {

StepAsk slipping(const Vector& position, Grip grip = Grip::slip) {
  StepAsk ask = step_at(position[2], contact_at_origin(grip));
  ask.frame.position_in_world = position;
  return ask;
}
StepAsk mapped(StepAsk ask) {
  ask.wheel.relocation = Relocation::return_mapping;
  return ask;
}
StepAsk moving(StepAsk ask, const Vector& velocity) {
  ask.frame.velocity_in_world = velocity;
  return ask;
}

}  // namespace

std::vector<Case> corpus_of_slipping() {
  const Scene flat = flat_ground();
  const Scene edge = ground(intersection_of({half_space(0, 0, 1, 0), half_space(1, 0, 0, 0.03125)}));
  const Scene step_up = ground(union_of({half_space(0, 0, 1, 0), box({0.0625, -1, -1}, {2, 1, 0.25})}));
  return {
      {"slip/rolls",
       flat,
       slipping({0.125, 0, 0.5}),
       {"relocation", "brake"},
       "Rolls, with B = mu N exactly."},
      {"slip/sideways",
       flat,
       slipping({0, 0.125, 0.5}),
       {"relocation", "friction"},
       "Slides sideways: case 3."},
      {"slip/band-corner",
       flat,
       slipping({0.125, 0.125, 0.5}, Grip::stick),
       {"relocation", "band-corner"},
       "To the corner of band and circle: two roots."},
      {"slip/starts-from-stick",
       flat,
       slipping({0, 0.25, 0.5}, Grip::stick),
       {"relocation", "friction"},
       "A pebble that stuck lets go: its static friction is the one that counts."},
      {"slip/uses-dynamic-friction",
       flat,
       slipping({0, 0.09375, 0.5}),
       {"friction"},
       "Between dynamic and static friction: a pebble that slips goes on slipping."},
      {"slip/comes-to-rest",
       flat,
       slipping({0, 0.03125, 0.5}),
       {"friction"},
       "Within the border: stick again."},
      {"slip/return-mapping",
       flat,
       mapped(slipping({0, 0.125, 0.5})),
       {"return-mapping", "spring-relocation"},
       "The same with return mapping: elsewhere than with the spring's rule."},
      {"slip/damped",
       flat,
       moving(slipping({0.125, 0, 0.5}), {4, 1, 0}),
       {"damping", "spring-relocation"},
       "Dampers: the spring alone would need another place."},
      {"slip/damped-return-mapping",
       flat,
       mapped(moving(slipping({0.125, 0, 0.5}), {4, 1, 0})),
       {"damping", "return-mapping", "spring-relocation"},
       "The same with return mapping."},
      {"slip/off-an-edge",
       edge,
       slipping({0.125, 0, 0.5}),
       {"lift-off", "edge"},
       "The pebble slips over an edge: free, though this step's force is still there."},
      {"slip/against-a-step",
       step_up,
       slipping({0.125, 0, 0.5}),
       {"broken"},
       "Slips under a step: the top of the strut is inside."},
      {"slip/onto-ice",
       {ground_materials(),
        painted(icy, half_space(-1, 0, 0, -0.03125), covered(dry, half_space(0, 0, 1, 0)))},
       slipping({0.125, 0, 0.5}),
       {"paint", "relocation"},
       "Slips onto ice: the new friction is the ice's."},
      {"slip/onto-no-material",
       {ground_materials(), painted(dry, half_space(1, 0, 0, 0.03125), half_space(0, 0, 1, 0))},
       slipping({0.125, 0, 0.5}),
       {"refusal"},
       "Slips off the paint to no material: refused."},
      {"slip/onto-a-wall",
       ground(half_space(16, 0, 1, 0)),
       slipping({0, 0.125, 0.5}),
       {"steep"},
       "The new normal is too steep."},
      {"slip/no-friction",
       flat,
       [] {
         StepAsk ask = slipping({0.125, 0.0625, 0.5});
         std::get<Contact>(ask.state).dynamic_friction = 0;
         return ask;
       }(),
       {"friction"},
       "mu = 0: the pebble follows the wheel."},
  };
}

}  // namespace groundtruth::cases
