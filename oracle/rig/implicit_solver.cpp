#include <groundtruth/rig/implicit_solver.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace groundtruth::rig {
namespace {

constexpr double converged_mismatch = 1e-11;
constexpr double greatest_mismatch = 1e-4;  // beyond which the step is given up
constexpr int most_newton_steps = 60;
constexpr int most_idle_rounds = 20;  // that do not halve the mismatch
constexpr int most_inner_steps = 50;

// All contacts around some velocities.
struct Point {
  Vector6 velocities;
  std::vector<AskedForce> asked;  // zero where there is no contact
  std::vector<BorneForce> borne;
  Vector6 imbalance;  // momentum that the forces do not explain
  double merit = 0;
};

class Solver {
 public:
  explicit Solver(const ImplicitProblem& problem) : problem_(problem), inverse_mass_(problem.mass) {}

  std::optional<ImplicitSolution> run() {
    Point at = point(velocities_of(problem_.start));
    loads_.assign(at.asked.size(), 0);
    ImplicitSolution solution;
    Point best = at;
    for (int idle = 0; mismatch(best) > converged_mismatch && idle < most_idle_rounds;) {
      const bool is_near =
          solution.convex_passes > 1 && solution.newton_steps < most_newton_steps && mismatch(at) < 1;
      const auto next = is_near ? newton_step(at) : std::nullopt;
      ++(next ? solution.newton_steps : solution.convex_passes);
      at = next ? *next : convex_pass(at);
      if (!std::isfinite(at.merit)) return std::nullopt;
      const bool is_better = mismatch(at) < mismatch(best) / 2;
      if (mismatch(at) < mismatch(best)) best = at;
      idle = is_better ? 0 : idle + 1;
    }
    if (mismatch(best) > greatest_mismatch) return std::nullopt;
    solution.mismatch = mismatch(best);
    solution.path_velocities = best.velocities;
    solution.velocities = explained_velocities(best);
    for (std::size_t i = 0; i < best.asked.size(); ++i)
      solution.forces_in_world.emplace_back(world_from_surface(best.asked[i]) * best.borne[i].force);
    return solution;
  }

 private:
  Point point(const Vector6& velocities) const {
    Point at{velocities, {}, {}, Vector6::Zero(), 0};
    const BodyState end = drifted(problem_.start, velocities, problem_.h);
    for (const ContactLaw& law : problem_.contacts) {
      at.asked.push_back(law.at(end));
      if (!problem_.turns) {
        at.asked.back().jacobian.rightCols<3>().setZero();
        at.asked.back().turning.setZero();
      }
      at.borne.push_back(borne(at.asked.back().asked, at.asked.back().border));
    }
    at.imbalance = problem_.mass * (velocities - explained_velocities(at));
    at.merit = at.imbalance.dot(inverse_mass_.solve(at.imbalance));
    return at;
  }

  Vector6 explained_velocities(const Point& at) const {
    Vector6 impulse = Vector6::Zero();
    for (std::size_t i = 0; i < at.asked.size(); ++i)
      impulse += at.asked[i].jacobian.transpose() * at.borne[i].force;
    return problem_.free_velocities + problem_.h * inverse_mass_.solve(impulse);
  }

  // Force that the change of momentum does not explain, in parts of what the contacts bear.
  double mismatch(const Point& at) const {
    const double unexplained = std::sqrt(at.merit * problem_.mass(0, 0)) / problem_.h;
    const Vector6 speeds = at.velocities.cwiseAbs() + problem_.free_velocities.cwiseAbs();
    double borne = 0, rounding = (problem_.mass.diagonal().cwiseProduct(speeds)).norm() / problem_.h;
    for (std::size_t i = 0; i < at.asked.size(); ++i) {
      const AskedForce& asked = at.asked[i];
      borne += at.borne[i].force.norm();
      rounding += (at.borne[i].derivative.cwiseAbs() *
                   (asked.stiffness.cwiseAbs() * (asked.jacobian.cwiseAbs() * speeds) + asked.granularity))
                      .norm();
    }
    return std::max(0.0, unexplained - 0x1p-49 * rounding) / std::max(borne, 1e-300);
  }

  // Nothing if no part of the step lowers the merit.
  std::optional<Point> newton_step(const Point& at) const {
    Matrix6 slope = problem_.mass;
    for (std::size_t i = 0; i < at.asked.size(); ++i) {
      const AskedForce& asked = at.asked[i];
      const Jacobian asked_less = asked.stiffness * asked.jacobian - asked.turning;
      slope += problem_.h * asked.jacobian.transpose() * at.borne[i].derivative * asked_less;
    }
    const Vector6 step = slope.partialPivLu().solve(-at.imbalance);
    for (double part = 1; part > 0x1p-8; part /= 2) {
      Point next = point(at.velocities + part * step);
      if (next.merit < (1 - 1e-4 * part) * at.merit) return next;
    }
    return std::nullopt;
  }

  // The discs, and how tangents and normals mix, are frozen: what is left has a strictly convex potential.
  Point convex_pass(const Point& from) {
    Vector6 velocities = from.velocities;
    for (int i = 0; i < most_inner_steps; ++i) {
      Vector6 imbalance = problem_.mass * (velocities - problem_.free_velocities);
      Matrix6 slope = problem_.mass;
      add_frozen(from, velocities, imbalance, slope);
      const Vector6 step = slope.llt().solve(-imbalance);
      const double part = exact_line_search(from, velocities, step);
      velocities += part * step;
      if (step.norm() <= 0x1p-50 * (velocities.norm() + problem_.free_velocities.norm())) break;
    }
    for (std::size_t i = 0; i < loads_.size(); ++i) loads_[i] = frozen_load(from, velocities, i);
    return point(velocities);
  }

  double frozen_load(const Point& from, const Vector6& velocities, std::size_t i) const {
    const AskedForce& asked = from.asked[i];
    const Eigen::Vector3d moved = asked.jacobian * (velocities - from.velocities);
    return std::max(0.0, asked.stiffness(2, 2) * moved.z() - asked.asked.z());
  }

  void add_frozen(const Point& from, const Vector6& velocities, Vector6& imbalance, Matrix6& slope) const {
    for (std::size_t i = 0; i < from.asked.size(); ++i) {
      const AskedForce& asked = from.asked[i];
      const Eigen::Vector3d stiffness = frozen_stiffness(asked);
      const Eigen::Vector3d moved = asked.jacobian * (velocities - from.velocities);
      const Eigen::Vector3d trial = asked.asked - stiffness.cwiseProduct(moved);
      const double disc = asked.border.friction * loads_[i];
      const BorneForce borne = borne_by_disc(trial, disc, asked.border.brake);
      imbalance -= problem_.h * asked.jacobian.transpose() * borne.force;
      slope += problem_.h * asked.jacobian.transpose() * borne.derivative * stiffness.asDiagonal() *
               asked.jacobian;
    }
  }

  static Eigen::Vector3d frozen_stiffness(const AskedForce& asked) {
    const double tangential = std::max(asked.stiffness(0, 0), asked.stiffness(1, 1));
    return {tangential, tangential, asked.stiffness(2, 2)};
  }

  // The potential's slope along the step rises: its root is enclosed.
  double exact_line_search(const Point& from, const Vector6& velocities, const Vector6& step) const {
    const auto slope_at = [&](double part) {
      const Vector6 there = velocities + part * step;
      Vector6 imbalance = problem_.mass * (there - problem_.free_velocities);
      Matrix6 unused = Matrix6::Zero();
      add_frozen(from, there, imbalance, unused);
      return step.dot(imbalance);
    };
    const double start = slope_at(0);
    if (std::abs(slope_at(1)) <= 0.1 * std::abs(start)) return 1;
    double low = 0, high = 1;
    while (slope_at(high) < 0 && high < 0x1p20) high *= 2;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (slope_at(middle) < 0 ? low : high) = middle;
    }
    return low > 0 ? low : high;
  }

  const ImplicitProblem& problem_;
  Eigen::LLT<Matrix6> inverse_mass_;
  std::vector<double> loads_;  // that the discs of a convex pass are cut for
};

}  // namespace

std::optional<ImplicitSolution> solve(const ImplicitProblem& problem) { return Solver(problem).run(); }

}  // namespace groundtruth::rig
