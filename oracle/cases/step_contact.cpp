// Wheels on the ground that roll, stand, skid and turn as aeroplanes' do.

#include <cmath>
#include <variant>

#include <groundtruth/cases/step_flavours.hpp>
#include <groundtruth/cases/step_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

// How the horizontal spring force compares to what friction bears.
struct Strain {
  double least = 0;
  double most = 0;
};

StepAsk contact_ask(const FacePoint& place, const Strain& strain, const Landmarks& landmarks,
                    Random& random) {
  StepAsk ask;
  ask.wheel = realistic_wheel(random);
  const Wheel& wheel = ask.wheel;
  Contact contact = contact_at(place, wheel, landmarks, random);

  const double z = random.uniform(wheel.z_min, wheel.z_zero);
  const double pressure = wheel.k_z * (z - wheel.z_zero);
  const double bearable = contact.static_friction * pressure / -wheel.k_xy;
  const double share_x = random.uniform(-1, 1);
  const double share_y = std::sqrt(1 - share_x * share_x) * random.sign();
  const double offset = bearable * random.uniform(strain.least, strain.most);
  const Vector pebble_in_wheel{offset * share_x, offset * share_y, z};

  ask.frame = frame_with(upright_on(place.plane.normal, random), pebble_in_wheel, place.point);
  ask.brake = random.one_in(4) ? 0 : random.uniform(0, 2) * contact.static_friction * pressure;
  ask.h = time_step(random);
  ask.state = contact;
  return ask;
}

Contact& contact_of(StepAsk& ask) { return std::get<Contact>(ask.state); }

void set_velocities(StepAsk& ask, double forward, double sideways, Random& random) {
  const Vector in_wheel{random.uniform(-forward, forward), random.uniform(-sideways, sideways),
                        random.uniform(-sideways, sideways)};
  ask.frame.velocity_in_world = rotated(ask.frame.world_from_wheel, in_wheel);
  if (contact_of(ask).grip == Grip::stick) return;
  // A slipping pebble keeps up with the wheel, more or less.
  const Vector lag{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
  contact_of(ask).pebble_velocity_in_world = plus(ask.frame.velocity_in_world, lag);
}

}  // namespace

StepAsk step_resting(const Landmarks& landmarks, Random& random) {
  StepAsk ask = contact_ask(foothold(landmarks, random), {0, 0.9}, landmarks, random);
  set_velocities(ask, 1e-3, 1e-3, random);
  if (!random.one_in(4)) ask.brake = 1e6;
  return ask;
}

StepAsk step_skidding(const Landmarks& landmarks, Random& random) {
  StepAsk ask = contact_ask(foothold(landmarks, random), {1, 4}, landmarks, random);
  const bool fast = random.one_in(2);
  set_velocities(ask, fast ? 80 : 1, fast ? 5 : 0.1, random);
  return ask;
}

StepAsk step_turning(const Landmarks& landmarks, Random& random) {
  StepAsk ask = contact_ask(foothold(landmarks, random), {0, 2}, landmarks, random);
  set_velocities(ask, 1, 0.1, random);
  ask.frame.angular_velocity_in_world = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3)};
  return ask;
}

StepAsk step_over_the_edge(const Landmarks& landmarks, Random& random) {
  FacePoint place = foothold(landmarks, random);
  for (int tries = 0; tries < 8; ++tries) {
    const EdgePoint edge = on_an_edge(pick_piece(landmarks, random), random);
    if (edge.plane.normal[2] > 0) place = {edge.point, edge.plane};
  }
  StepAsk ask = contact_ask(place, {1, 8}, landmarks, random);
  set_velocities(ask, 10, 1, random);
  return ask;
}

}  // namespace groundtruth::cases
