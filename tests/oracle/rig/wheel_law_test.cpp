// What holds of the force at every wheel step of a motion, reckoned in rationals from the doubles that were
// answered: they are the nearest ones, so laws hold up to their rounding, 2^-50 of the force.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <groundtruth/rig/motion.hpp>
#include <groundtruth/tests/oracle/rig/random_scenarios.hpp>

namespace groundtruth::rig {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

const Rational rounding = Rational(0x1p-50);

RationalVector rational(const Vector& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }
Rational dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
RationalVector difference(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// q^-1 v q.
RationalVector in_wheel(const Quaternion& q, const RationalVector& v) {
  const Rational w = q[0];
  const RationalVector u{-Rational(q[1]), -Rational(q[2]), -Rational(q[3])};
  const RationalVector u_v = cross(u, v);
  const Rational uu = dot(u, u), uv = dot(u, v);
  RationalVector turned;
  for (std::size_t i = 0; i < 3; ++i)
    turned[i] = ((w * w - uu) * v[i] + 2 * uv * u[i] + 2 * w * u_v[i]) / (w * w + uu);
  return turned;
}

// Springs and dampers, on the pebble, in wheel axes: before any clip.
RationalVector asked_force(const StepAsk& ask, const Contact& contact) {
  const Frame& frame = ask.frame;
  const auto& q = frame.world_from_wheel;
  const RationalVector arm = difference(rational(contact.pebble_in_world), rational(frame.position_in_world));
  const RationalVector turning = cross(rational(frame.angular_velocity_in_world), arm);
  const RationalVector p = in_wheel(q, arm);
  const RationalVector w = in_wheel(
      q, difference(difference(rational(contact.pebble_velocity_in_world), rational(frame.velocity_in_world)),
                    turning));
  const Rational k = ask.wheel.k_xy, d = ask.wheel.d_xy;
  return {k * p[0] + d * w[0], k * p[1] + d * w[1],
          Rational(ask.wheel.k_z) * (p[2] - Rational(ask.wheel.z_zero)) + Rational(ask.wheel.d_z) * w[2]};
}

void holds_the_laws(const StepAsk& ask, const Stepped& stepped) {
  const auto* contact = std::get_if<Contact>(&ask.state);
  if (contact == nullptr) return;
  const auto& q = ask.frame.world_from_wheel;
  const RationalVector on_frame = rational(stepped.force_on_frame_in_world);
  const Rational squared = dot(on_frame, on_frame);
  if (squared == 0) return;
  const RationalVector n_world = rational(contact->normal_in_world), n = in_wheel(q, n_world);
  const RationalVector f = in_wheel(q, on_frame);
  const Rational normal = dot(f, n), nn = dot(n, n), slack = rounding * squared;
  // The ground never pulls.
  RC_ASSERT(normal > 0);
  // Disc and band, as squares; the band's axis is (-n_z, 0, n_x).
  const Rational mu = contact->grip == Grip::stick ? contact->static_friction : contact->dynamic_friction;
  RC_ASSERT(squared * nn - normal * normal <= mu * mu * normal * normal + slack * nn);
  const Rational along = -n[2] * f[0] + n[0] * f[2], rr = n[0] * n[0] + n[2] * n[2], brake = ask.brake;
  RC_ASSERT(along * along <= brake * brake * rr + slack * rr);
  // The clip leaves the normal part alone.
  const Rational changed = normal + dot(asked_force(ask, *contact), n);
  RC_ASSERT(changed * changed <= rounding * slack * nn);
  const auto* after = std::get_if<Contact>(&stepped.state);
  if (after == nullptr) return;
  if (after->grip == Grip::stick) RC_ASSERT(after->pebble_in_world == contact->pebble_in_world);
}

// An engine that holds each of its answers against the laws.
class Lawful : public implementations::EngineOnScene {
 public:
  Lawful(const std::string& engine, const Scene& scene)
      : engine_(implementations::make_engine(engine)->on(scene)) {}

  implementations::Answered answer(const Ask& ask) const override {
    implementations::Answered answered = engine_->answer(ask);
    const auto& step = std::get<StepAnswer>(answered.answer);
    if (const auto* stepped = std::get_if<Stepped>(&step)) holds_the_laws(std::get<StepAsk>(ask), *stepped);
    return answered;
  }

 private:
  std::unique_ptr<const implementations::EngineOnScene> engine_;
};

void obeys(const std::string& engine, int steps) {
  properties::Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  const Scenario scenario = random_scenario(dice);
  const Lawful ground(engine, scenario.scene);
  Motion motion(scenario.machine, ground, scenario.integrator, scenario.h);
  MotionState state = scenario.state_at_start();
  for (int i = 0; i < steps; ++i)
    if (motion.advance(state, scenario.inputs.at(i * scenario.h)).halt != Halt::none) return;
}

RC_GTEST_PROP(WheelLaw, ExactForcesLieInTheBorderPressAndKeepTheirNormalPart, ()) { obeys("exact", 20); }

RC_GTEST_PROP(WheelLaw, FastForcesLieInTheBorderPressAndKeepTheirNormalPart, ()) { obeys("fast", 60); }

// The friction on the body and the way that the pebble went: on level ground, upright, with return mapping.
RC_GTEST_PROP(WheelLaw, SlipDissipates, ()) {
  properties::Dice dice(*rc::gen::arbitrary<std::uint64_t>());
  Scenario scenario = random_level_scenario(dice);
  scenario.machine.wheels[0].wheel.relocation = Relocation::return_mapping;
  scenario.integrator = Integrator::semi_implicit;
  const auto ground = implementations::make_engine("fast")->on(scenario.scene);
  Motion motion(scenario.machine, *ground, scenario.integrator, scenario.h);
  MotionState state{scenario.start, {Free{}}, 0};
  for (int i = 0; i < 200; ++i) {
    const WheelState before = state.wheels[0];
    const StepRecord& record = motion.advance(state, scenario.inputs.at(i * scenario.h));
    if (record.halt != Halt::none) return;
    const auto* from = std::get_if<Contact>(&before);
    const auto* to = std::get_if<Contact>(&state.wheels[0]);
    if (from == nullptr || to == nullptr || to->grip == Grip::stick) continue;
    Rational work = 0;
    for (std::size_t axis = 0; axis < 2; ++axis)
      work += Rational(record.forces_in_world[0][static_cast<Eigen::Index>(axis)]) *
              (Rational(to->pebble_in_world[axis]) - Rational(from->pebble_in_world[axis]));
    RC_ASSERT(work <= Rational(1e-9));
  }
}

}  // namespace
}  // namespace groundtruth::rig
