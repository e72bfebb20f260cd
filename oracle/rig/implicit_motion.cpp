#include <groundtruth/rig/body.hpp>
#include <groundtruth/rig/implicit_solver.hpp>
#include <groundtruth/rig/motion.hpp>
#include <groundtruth/rig/wheel_steps.hpp>

namespace groundtruth::rig {
namespace {

class ImplicitStep {
 public:
  ImplicitStep(const Machine& machine, const implementations::EngineOnScene& ground, double h,
               const Controls& controls, const MotionState& start)
      : machine_(machine),
        ground_(ground),
        h_(h),
        controls_(controls),
        start_(start),
        touching_(start.wheels) {}

  StepRecord take(MotionState& state) {
    lay_pebbles_down();
    const Matrix6 mass = mass_matrix(machine_, start_.body);
    const Vector6 free_velocities = velocities_of(start_.body) + h_ * mass.llt().solve(wrench_without_ground(
                                                                          machine_, start_.body, controls_));
    if (!foresee_touchdowns(free_velocities)) return record_;
    ImplicitProblem problem{start_.body, mass, free_velocities, h_, machine_.turns(), {}};
    for (const std::size_t i : in_contact())
      problem.contacts.emplace_back(machine_.wheels[i], std::get<Contact>(touching_[i]), controls_, h_);
    const auto solution = solve(problem);
    if (!solution) {
      record_.halt = Halt::not_solved;
      return record_;
    }
    finish(*solution, state);
    return record_;
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
      const auto done = ask(i, end, touching_[i]);
      if (!done) return false;
      touching_[i] = done->state;
      if (auto* contact = std::get_if<Contact>(&touching_[i])) let_arrive(*contact, i, end);
    }
    return true;
  }

  // The pebble of a wheel that touches down comes along with it: nothing is stretched sideways yet.
  void let_arrive(Contact& contact, std::size_t wheel, const BodyState& end) const {
    const Vector& v = frame_of(end, machine_.wheels[wheel], controls_).velocity_in_world;
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
    const StepAsk ask = step_ask(machine_.wheels[wheel], body, state, controls_, h_);
    return stepped(ground_.answer(ask).answer, wheel, record_);
  }

  void finish(const ImplicitSolution& solution, MotionState& state) {
    record_.newton_steps = solution.newton_steps;
    record_.convex_passes = solution.convex_passes;
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
      const AskedForce asked = ContactLaw(machine_.wheels[i], contact, controls_, h_).at(end);
      record_.forces_in_world[i] = force;
      record_.border_violation = std::max(record_.border_violation, border_violation(force, asked));
    }
  }

  const Machine& machine_;
  const implementations::EngineOnScene& ground_;
  const double h_;
  const Controls& controls_;
  const MotionState start_;
  std::vector<WheelState> touching_;
  StepRecord record_;
};

}  // namespace

StepRecord Motion::advance_implicitly(MotionState& state, const Controls& controls) const {
  return ImplicitStep(machine_, ground_, h_, controls, state).take(state);
}

}  // namespace groundtruth::rig
