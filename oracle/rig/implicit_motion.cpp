#include <algorithm>

#include <groundtruth/rig/body.hpp>
#include <groundtruth/rig/implicit_solver.hpp>
#include <groundtruth/rig/motion.hpp>
#include <groundtruth/rig/wheel_steps.hpp>

namespace groundtruth::rig {
namespace {

constexpr int most_parts = 64;

class ImplicitStep {
 public:
  ImplicitStep(const Machine& machine, WheelSteps& wheel_steps, double h, const Controls& controls,
               const MotionState& start, StepRecord& record)
      : machine_(machine),
        wheel_steps_(wheel_steps),
        h_(h),
        controls_(controls),
        start_(start),
        touching_(start.wheels),
        record_(record) {}

  void take(MotionState& state) {
    lay_pebbles_down();
    const Eigen::Matrix3d world_from_body = rotation_of(start_.body.world_from_body);
    const Vector6 wrench = wrench_without_ground(machine_, start_.body, world_from_body, controls_);
    const Vector6 free_velocities =
        velocities_of(start_.body) + h_ * accelerations(machine_, world_from_body, wrench);
    if (!foresee_touchdowns(free_velocities)) return;
    ImplicitProblem problem{
        start_.body, mass_matrix(machine_, world_from_body), free_velocities, h_, machine_.turns(), {}};
    for (const std::size_t i : in_contact())
      problem.contacts.emplace_back(machine_.wheels[i], std::get<Contact>(touching_[i]), controls_, h_);
    const auto solution = solve(problem);
    if (!solution) {
      record_.halt = Halt::not_solved;
      return;
    }
    finish(*solution, state);
  }

 private:
  // Stretch and its rate belong together only if the pebble lies still when the step begins; where it went
  // before must not count twice (proofs-notes/rig.md, 2).
  void lay_pebbles_down() {
    for (WheelState& wheel : touching_)
      if (auto* contact = std::get_if<Contact>(&wheel)) contact->pebble_velocity_in_world = {};
  }

  // A wheel that would touch the ground at the end of the step if nothing pushed it back is in contact
  // already: else the strut would be compressed for nothing.
  bool foresee_touchdowns(const Vector6& free_velocities) {
    const BodyState end = drifted(start_.body, free_velocities, h_);
    for (std::size_t i = 0; i < touching_.size(); ++i) {
      if (!std::holds_alternative<Free>(touching_[i])) continue;
      auto done = ask(i, end, touching_[i]);
      if (!done && record_.halt == Halt::wheel_broken) done = ask_above(i, end);
      if (!done) return false;
      record_.halt = Halt::none;
      touching_[i] = done->state;
      if (auto* contact = std::get_if<Contact>(&touching_[i])) let_arrive(*contact, i, end);
    }
    return true;
  }

  // In a long step a free fall ends deeper than the strut reaches; pushed back, the wheel need not. The
  // pebble lies where the strut's line meets the ground within the way that the wheel came.
  std::optional<Stepped> ask_above(std::size_t wheel, const BodyState& end) {
    const Wheel& strut = machine_.wheels[wheel].wheel;
    Frame frame = frame_at(wheel, end);
    const Eigen::Vector3d bottom = vector_of(frame.position_in_world), down = world_from_wheel(frame).col(2);
    const double way = (bottom - vector_of(frame_at(wheel, start_.body).position_in_world)).norm();
    const auto depth = wheel_steps_.entry(bottom + (strut.z_min - way) * down, bottom + strut.z_max * down);
    if (!depth) return std::nullopt;
    const double z = strut.z_min - way + *depth * (strut.z_max - strut.z_min + way);
    const Eigen::Vector3d lifted = bottom + (z - (strut.z_min + strut.z_max) / 2) * down;
    frame.position_in_world = {lifted.x(), lifted.y(), lifted.z()};
    record_.halt = Halt::none;
    return wheel_steps_.step(wheel, frame, Free{}, controls_, record_);
  }

  // The pebble of a wheel that touches down comes along with it: nothing is stretched sideways yet.
  void let_arrive(Contact& contact, std::size_t wheel, const BodyState& end) const {
    const Vector v = frame_at(wheel, end).velocity_in_world;
    const Vector& n = contact.normal_in_world;
    const double along =
        (v[0] * n[0] + v[1] * n[1] + v[2] * n[2]) / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (std::size_t i = 0; i < 3; ++i) contact.pebble_velocity_in_world[i] = v[i] - along * n[i];
  }

  std::vector<std::size_t> in_contact() const {
    std::vector<std::size_t> wheels;
    for (std::size_t i = 0; i < touching_.size(); ++i)
      if (std::holds_alternative<Contact>(touching_[i])) wheels.push_back(i);
    return wheels;
  }

  std::optional<Stepped> ask(std::size_t wheel, const BodyState& body, const WheelState& state) {
    return wheel_steps_.step(wheel, frame_at(wheel, body), state, controls_, record_);
  }

  Frame frame_at(std::size_t wheel, const BodyState& body) const {
    return frame_of(body, rotation_of(body.world_from_body), machine_.wheels[wheel], controls_);
  }

  void finish(const ImplicitSolution& solution, MotionState& state) {
    record_.newton_steps = std::max(record_.newton_steps, solution.newton_steps);
    record_.convex_passes = std::max(record_.convex_passes, solution.convex_passes);
    record_.forces_in_world.assign(touching_.size(), Eigen::Vector3d::Zero());
    BodyState end = drifted(start_.body, solution.path_velocities, h_);
    end.velocity_in_world = solution.velocities.head<3>();
    end.angular_velocity_in_world = solution.velocities.tail<3>();
    measure(solution, end);
    std::vector<WheelState> wheels;
    for (std::size_t i = 0; i < touching_.size(); ++i) {
      const auto done = ask(i, end, touching_[i]);
      if (!done) return;
      wheels.push_back(done->state);
    }
    state = {end, std::move(wheels), start_.steps + 1};
  }

  void measure(const ImplicitSolution& solution, const BodyState& end) {
    std::size_t k = 0;
    for (const std::size_t i : in_contact()) {
      const Eigen::Vector3d& force = solution.forces_in_world[k++];
      const auto& contact = std::get<Contact>(touching_[i]);
      const Vector& n = contact.normal_in_world;
      const Eigen::Matrix3d wheel_from_world = world_from_wheel(frame_at(i, end)).transpose();
      const double violation = border_violation(wheel_from_world * force, wheel_from_world * vector_of(n),
                                                border_of(contact, machine_.wheels[i], controls_));
      record_.forces_in_world[i] = force;
      record_.border_violation = std::max(record_.border_violation, violation);
    }
  }

  const Machine& machine_;
  WheelSteps& wheel_steps_;
  const double h_;
  const Controls& controls_;
  const MotionState start_;
  std::vector<WheelState> touching_;
  StepRecord& record_;
};

}  // namespace

void Motion::advance_implicitly(MotionState& state, const Controls& controls) {
  for (int parts = 1; parts <= most_parts; parts *= 2) {
    const double h = h_ / parts;
    WheelSteps shorter(machine_, ground_, h);
    MotionState next = state;
    record_.halt = Halt::none;
    record_.parts = parts;
    for (int i = 0; i < parts && record_.halt == Halt::none; ++i)
      ImplicitStep(machine_, parts == 1 ? wheel_steps_ : shorter, h, controls, next, record_).take(next);
    if (record_.halt == Halt::not_solved) continue;
    if (record_.halt == Halt::none) state = {next.body, std::move(next.wheels), state.steps + 1};
    return;
  }
}

}  // namespace groundtruth::rig
