// Steps seen from elsewhere: in another world frame, in a mirror, in other units, from a moving train.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/motions.hpp>
#include <groundtruth/tests/properties/step_cases.hpp>

namespace groundtruth::properties {
namespace {

using Matrix = std::array<Vector, 3>;

StepAnswer step(const StepCase& c) { return Ground(c.shape).step(c.ask); }

// Both answers but for their vectors: outcome, grip, friction.
bool same_but_for_vectors(const StepAnswer& left, const StepAnswer& right) {
  if (outcome(left) != outcome(right)) return false;
  if (outcome(left) != "stick" && outcome(left) != "slip") return true;
  const Contact& a = contact_of(left);
  const Contact& b = contact_of(right);
  return a.static_friction == b.static_friction && a.dynamic_friction == b.dynamic_friction &&
         a.maximum_force == b.maximum_force;
}

// Whether `right` is matrix * left up to the rounding of both.
bool nearly(const Matrix& matrix, const Vector& left, const Vector& right) {
  const Vector expected = product(matrix, left);
  for (std::size_t i = 0; i < 3; ++i)
    if (std::fabs(expected[i] - right[i]) > 0x1p-48 * (1 + std::hypot(left[0], left[1], left[2])))
      return false;
  return true;
}

bool nearly(const Matrix& matrix, const StepAnswer& left, const StepAnswer& right) {
  if (!same_but_for_vectors(left, right)) return false;
  if (!std::holds_alternative<Stepped>(left)) return true;
  if (!nearly(matrix, force_of(left), force_of(right))) return false;
  if (outcome(left) == "free") return true;
  return nearly(matrix, contact_of(left).pebble_in_world, contact_of(right).pebble_in_world) &&
         nearly(matrix, contact_of(left).pebble_velocity_in_world,
                contact_of(right).pebble_velocity_in_world);
}

// With the vectors of an answer mapped; for maps that do not round.
template <typename Map>
StepAnswer mapped_answer(const StepAnswer& answer, const Map& map) {
  if (!std::holds_alternative<Stepped>(answer)) return answer;
  Stepped stepped = std::get<Stepped>(answer);
  map(stepped.force_on_frame_in_world);
  if (auto* contact = std::get_if<Contact>(&stepped.state)) {
    map(contact->pebble_in_world);
    map(contact->pebble_velocity_in_world);
    map(contact->normal_in_world);
  }
  return stepped;
}

bool same(const StepAnswer& left, const StepAnswer& right) {
  const bool both_refuse = outcome(left) == "refusal" && outcome(right) == "refusal";
  return both_refuse || left == right;
}

RC_GTEST_PROP(StepMotions, TheLengthOfTheQuaternionDoesNotMatter, ()) {
  const StepCase c = *lattice_steps();
  StepCase scaled = c;
  const double factor = *rc::gen::element(-1.0, 2.0, -0.5, 0x1p-30);
  for (double& part : scaled.ask.frame.world_from_wheel) part *= factor;
  RC_ASSERT(same(step(scaled), step(c)));
}

RC_GTEST_PROP(StepMotions, QuarterTurnsTurnTheAnswerBitForBit, ()) {
  const StepCase c = *lattice_steps();
  Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const Quaternion q = quarter_turns(dice);
  Matrix matrix = scaled_rotation(q);
  for (Vector& row : matrix)
    for (double& entry : row) entry /= squared_length(q);
  const StepAnswer turned = step(moved(c, q, {}));
  const auto turn = [&](Vector& vector) { vector = product(matrix, vector); };
  // The normal is the leaf's, as written: times ||q||^2.
  StepAnswer expected = mapped_answer(step(c), turn);
  if (outcome(expected) == "stick" || outcome(expected) == "slip")
    for (double& n : std::get<Contact>(std::get<Stepped>(expected).state).normal_in_world)
      n *= squared_length(q);
  RC_ASSERT(same(turned, expected));
}

RC_GTEST_PROP(StepMotions, RationalRotationsTurnTheAnswer, ()) {
  StepCase c = *lattice_steps();
  const Quaternion q = *rc::gen::elementOf(
      std::vector<Quaternion>{{2, 0, 0, 1}, {1, 2, 0, 0}, {2, 0, -1, 0}, {1, 1, 1, 0}, {3, 1, -2, 1}});
  const double length = squared_length(q);
  for (double& rate : c.ask.frame.angular_velocity_in_world) rate *= length;
  c = enlarged(c, length);
  Matrix matrix = scaled_rotation(q);
  for (Vector& row : matrix)
    for (double& entry : row) entry /= length;
  RC_ASSERT(nearly(matrix, step(c), step(moved(c, q, {}))));
}

RC_GTEST_PROP(StepMotions, AShiftedWorldGivesTheSameForcesAndVelocities, ()) {
  const StepCase c = *lattice_steps();
  Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const Vector shift = lattice_vector(dice, 1000);
  const StepAnswer before = step(c);
  const StepAnswer after = step(moved(c, {1, 0, 0, 0}, shift));
  RC_ASSERT(same_but_for_vectors(after, before));
  if (!std::holds_alternative<Stepped>(before)) return;
  RC_ASSERT(force_of(after) == force_of(before));
  if (outcome(before) == "free") return;
  RC_ASSERT(contact_of(after).pebble_velocity_in_world == contact_of(before).pebble_velocity_in_world);
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = contact_of(before).pebble_in_world[i] + shift[i];
    RC_ASSERT(std::fabs(contact_of(after).pebble_in_world[i] - expected) <= 0x1p-40);
  }
}

RC_GTEST_PROP(StepMotions, InAMirrorTheAnswerIsMirrored, ()) {
  const StepCase c = *rc::gen::oneOf(lattice_steps(), wild_steps());
  const auto axis = static_cast<std::size_t>(*rc::gen::inRange(0, 2));
  const auto mirror = [axis](Vector& vector) { vector[axis] = -vector[axis]; };
  RC_ASSERT(same(step(mirrored(c, axis)), mapped_answer(step(c), mirror)));
}

// Twice the metre: lengths, velocities and forces double.
RC_GTEST_PROP(StepMotions, InOtherMetresTheAnswerIsTheSame, ()) {
  const StepCase c = *lattice_steps();
  const StepCase large = enlarged(c, 2);
  std::vector<Material> materials = palette();
  for (Material& material : materials)
    if (material.maximum_force) *material.maximum_force *= 2;
  const auto enlarge = [](Vector& vector) {
    for (double& coordinate : vector) coordinate *= 2;
  };
  StepAnswer expected = mapped_answer(step(c), enlarge);
  if (outcome(expected) == "stick" || outcome(expected) == "slip") {
    auto& contact = std::get<Contact>(std::get<Stepped>(expected).state);
    for (double& n : contact.normal_in_world) n /= 2;
    if (contact.maximum_force) *contact.maximum_force *= 2;
  }
  RC_ASSERT(same(Ground(Scene{materials, large.shape}).step(large.ask), expected));
}

// Half the second: h doubles, velocities halve, d doubles.
RC_GTEST_PROP(StepMotions, InOtherSecondsTheAnswerIsTheSame, ()) {
  const StepCase c = *lattice_steps();
  StepCase slow = c;
  const auto halve = [](Vector& vector) {
    for (double& coordinate : vector) coordinate /= 2;
  };
  slow.ask.h *= 2;
  slow.ask.wheel.d_xy *= 2;
  slow.ask.wheel.d_z *= 2;
  halve(slow.ask.frame.velocity_in_world);
  halve(slow.ask.frame.angular_velocity_in_world);
  if (auto* contact = std::get_if<Contact>(&slow.ask.state)) halve(contact->pebble_velocity_in_world);
  StepAnswer expected = step(c);
  if (outcome(expected) == "stick" || outcome(expected) == "slip")
    halve(std::get<Contact>(std::get<Stepped>(expected).state).pebble_velocity_in_world);
  RC_ASSERT(same(step(slow), expected));
}

// w depends on w_t - v - omega x (p_t - b) only, and the answer on no other velocity.
RC_GTEST_PROP(StepMotions, OnlyTheVelocityOfThePebbleAgainstTheFrameCounts, ()) {
  const StepCase c = *lattice_steps();
  Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const auto* contact = std::get_if<Contact>(&c.ask.state);
  if (!contact) return;
  StepCase other = c;
  const Vector train = lattice_vector(dice, 100);
  const Frame& frame = c.ask.frame;
  Vector arm;
  for (std::size_t i = 0; i < 3; ++i) arm[i] = contact->pebble_in_world[i] - frame.position_in_world[i];
  const Vector& omega = frame.angular_velocity_in_world;
  for (std::size_t i = 0; i < 3; ++i) {
    const double turning = omega[(i + 1) % 3] * arm[(i + 2) % 3] - omega[(i + 2) % 3] * arm[(i + 1) % 3];
    other.ask.frame.velocity_in_world[i] += turning + train[i];
    std::get<Contact>(other.ask.state).pebble_velocity_in_world[i] += train[i];
  }
  other.ask.frame.angular_velocity_in_world = {};
  RC_ASSERT(same(step(other), step(c)));
}

}  // namespace
}  // namespace groundtruth::properties
