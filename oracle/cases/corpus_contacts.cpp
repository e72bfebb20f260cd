// A wheel on its pebble: forces, and how a contact ends (SPEC section 5, from stick).

#include "corpus_steps.hpp"

namespace groundtruth::cases {
namespace {

Contact stuck() { return contact_at_origin(Grip::stick); }

StepAsk moved(StepAsk ask, const Vector& position) {
  ask.frame.position_in_world = position;
  return ask;
}
StepAsk moving(StepAsk ask, const Vector& velocity, const Vector& angular_velocity = {}) {
  ask.frame.velocity_in_world = velocity;
  ask.frame.angular_velocity_in_world = angular_velocity;
  return ask;
}
StepAsk limited(double maximum_force) {
  StepAsk ask = step_at(0.5, stuck());
  std::get<Contact>(ask.state).maximum_force = maximum_force;
  return ask;
}

}  // namespace

std::vector<Case> corpus_of_contacts() {
  const Scene flat = flat_ground();
  Contact tilted = stuck();
  tilted.normal_in_world = {16, 0, 1};
  StepAsk long_strut = step_at(0.875, stuck());
  long_strut.wheel.z_max = 1;
  return {
      {"contact/pressed",
       flat,
       step_at(0.5, stuck()),
       {"force-on-frame-sign"},
       "Pressed by a quarter of a metre: the frame is pushed up with 16384 N."},
      {"contact/sideways",
       flat,
       moved(step_at(0.5, stuck()), {0.015625, 0.03125, 0.5}),
       {"force-on-frame-sign"},
       "The frame has moved aside: the spring pulls it back; the pebble stays to the last bit."},
      {"contact/damped",
       flat,
       moving(step_at(0.5, stuck()), {0.25, 0, -1}),
       {"damping", "mixed-frames"},
       "A moving frame: the dampers' force is in it."},
      {"contact/turning",
       flat,
       moving(moved(step_at(0.5, stuck()), {0.015625, 0, 0.5}), {}, {0, 0, 4}),
       {"omega", "frame-rotation-ignored"},
       "A frame that turns about z moves the pebble's offset too."},
      {"contact/turning-about-x",
       flat,
       moving(step_at(0.5, stuck()), {}, {2, 0, 0}),
       {"omega", "frame-rotation-ignored"},
       "A frame that rolls moves the pebble sideways."},
      {"contact/lifted-off", flat, step_at(1, stuck()), {"lift-off", "no-liftoff"}, "p_z > z_max: free."},
      {"contact/at-z-max",
       flat,
       step_at(0.75, stuck()),
       {"lift-off", "border"},
       "p_z = z_max exactly: free."},
      {"contact/at-z-min",
       flat,
       step_at(0.25, stuck()),
       {"broken", "border"},
       "p_z = z_min exactly: broken."},
      {"contact/one-ulp-from-broken",
       flat,
       step_at(0x1.0000000000001p-2, stuck()),
       {"broken", "one-ulp"},
       "One ulp above z_min: holds."},
      {"contact/rebound",
       flat,
       moving(step_at(0.625, stuck()), {0, 0, 9}),
       {"tensile", "tensile-contact"},
       "The frame flies up: the damper would pull, so the contact ends."},
      {"contact/no-force-left",
       flat,
       moving(step_at(0.625, stuck()), {0, 0, 8}),
       {"tensile", "border"},
       "F'_z = 0 exactly: nothing presses, free."},
      {"contact/pulled-beyond-z-zero",
       flat,
       long_strut,
       {"tensile"},
       "Between z_zero and z_max the spring pulls: free."},
      {"contact/gave-way", flat, limited(16000), {"gave-way"}, "Pressed harder than the ground bears."},
      {"contact/at-its-limit", flat, limited(16384), {"gave-way", "border"}, "F'_z = F_m exactly: it holds."},
      {"contact/one-ulp-over-its-limit",
       flat,
       limited(0x1.fffffffffffffp+13),
       {"gave-way", "one-ulp"},
       "F'_z one ulp above F_m."},
      {"contact/on-water", flat, limited(0), {"gave-way"}, "F_m = 0: gives way under any force."},
      {"contact/too-steep",
       flat,
       step_at(0.5, tilted),
       {"steep"},
       "The pebble's own normal is too steep for the wheel."},
      {"contact/stays-on-the-border",
       flat,
       moved(step_at(0.5, stuck()), {0.0625, 0, 0.5}),
       {"border", "brake"},
       "F'_x = B exactly: sticks."},
      {"contact/uses-static-friction",
       flat,
       moved(step_at(0.5, stuck()), {0, 0.09375, 0.5}),
       {"friction"},
       "Between dynamic and static friction: a pebble that sticks stays."},
  };
}

}  // namespace groundtruth::cases
