// Wheels in the air, above or in a face.

#include <groundtruth/cases/step_flavours.hpp>
#include <groundtruth/cases/step_parts.hpp>
#include <groundtruth/cases/vector_arithmetic.hpp>

namespace groundtruth::cases {
namespace {

StepAsk free_ask(const Wheel& wheel, const Frame& frame, Random& random) {
  StepAsk ask;
  ask.wheel = wheel;
  ask.frame = frame;
  ask.frame.velocity_in_world = {random.uniform(-80, 80), random.uniform(-5, 5), random.uniform(-5, 5)};
  ask.brake = random.one_in(2) ? 0 : random.uniform(0, 20000);
  ask.h = time_step(random);
  ask.state = Free{};
  return ask;
}

// With a point of a face at (0, 0, z) of the wheel frame.
StepAsk free_with_face_at(const Wheel& wheel, double z, const Landmarks& landmarks, Random& random) {
  const FacePoint place = foothold(landmarks, random);
  const Vector up{0, 0, 1};
  const Quaternion world_from_wheel = upright_on(random.one_in(2) ? up : place.plane.normal, random);
  return free_ask(wheel, frame_with(world_from_wheel, {0, 0, z}, place.point), random);
}

}  // namespace

StepAsk step_free_hit(const Landmarks& landmarks, Random& random) {
  const Wheel wheel = realistic_wheel(random);
  const double z = random.uniform(wheel.z_min, wheel.z_max);
  return free_with_face_at(wheel, z, landmarks, random);
}

StepAsk step_free_miss(const Landmarks& landmarks, Random& random) {
  const Wheel wheel = realistic_wheel(random);
  const double z = wheel.z_max + random.uniform(0, 2);
  return free_with_face_at(wheel, z, landmarks, random);
}

StepAsk step_free_in_ground(const Landmarks& landmarks, Random& random) {
  const Wheel wheel = realistic_wheel(random);
  const double z = wheel.z_min - random.uniform(0, 1);
  return free_with_face_at(wheel, z, landmarks, random);
}

StepAsk step_free_limits(const Landmarks& landmarks, Random& random) {
  const Wheel wheel = short_wheel(random);
  const double z = random.one_in(2) ? wheel.z_min : wheel.z_max;
  const FacePoint place = foothold(landmarks, random);
  const Quaternion world_from_wheel = right_angle_orientation(random);
  return free_ask(wheel, frame_with(world_from_wheel, {0, 0, z}, place.point), random);
}

}  // namespace groundtruth::cases
