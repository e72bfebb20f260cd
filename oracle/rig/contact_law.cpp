#include <groundtruth/rig/contact_law.hpp>

#include <algorithm>
#include <cmath>

namespace groundtruth::rig {
namespace {

// The columns of Q, in wheel axes, for a normal in wheel axes.
Eigen::Matrix3d surface_axes(const Eigen::Vector3d& n) {
  const double r = std::hypot(n.x(), n.z()), length = n.norm();
  Eigen::Matrix3d axes;
  axes.col(0) = Eigen::Vector3d(-n.z(), 0, n.x()) / r;
  axes.col(1) = Eigen::Vector3d(-n.x() * n.y(), r * r, -n.y() * n.z()) / (r * length);
  axes.col(2) = -n / length;
  return axes;
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

// The friction that disc and band leave, and its derivatives: by the friction asked for, and by the radius.
struct Friction2 {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  Eigen::Matrix2d by_asked = Eigen::Matrix2d::Zero();
  Eigen::Vector2d by_disc = Eigen::Vector2d::Zero();
};

Friction2 nearest_friction(const Eigen::Vector2d& asked, double disc, double brake) {
  const double length = std::hypot(asked.x(), asked.y());  // squares of tiny forces would vanish
  if (std::abs(asked.x()) <= brake && length <= disc)
    return {asked, Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero()};
  const double x = std::copysign(brake, asked.x());
  if (brake < disc) {
    const double s = std::sqrt((disc - brake) * (disc + brake));
    if (std::abs(asked.y()) <= s) return {{x, asked.y()}, Eigen::Vector2d(0, 1).asDiagonal(), {0, 0}};
    if (brake * std::abs(asked.y()) <= std::abs(asked.x()) * s)
      return {
          {x, std::copysign(s, asked.y())}, Eigen::Matrix2d::Zero(), {0, std::copysign(disc / s, asked.y())}};
  }
  if (length == 0) return {};
  const Eigen::Vector2d direction = asked / length;
  return {disc * direction, disc / length * (Eigen::Matrix2d::Identity() - direction * direction.transpose()),
          direction};
}

}  // namespace

BorneForce borne(const Eigen::Vector3d& asked, const Border& border) {
  const double load = -asked.z();
  if (!(load > 0)) return {};
  const Friction2 friction = nearest_friction(asked.head<2>(), border.friction * load, border.brake);
  BorneForce result;
  result.force << friction.force, asked.z();
  result.derivative.topLeftCorner<2, 2>() = friction.by_asked;
  result.derivative.topRightCorner<2, 1>() = -border.friction * friction.by_disc;
  result.derivative(2, 2) = 1;
  return result;
}

BorneForce borne_by_disc(const Eigen::Vector3d& asked, double disc, double brake) {
  const Friction2 friction = nearest_friction(asked.head<2>(), disc, brake);
  BorneForce result;
  result.force << friction.force, std::min(asked.z(), 0.0);
  result.derivative.topLeftCorner<2, 2>() = friction.by_asked;
  result.derivative(2, 2) = asked.z() < 0 ? 1 : 0;
  return result;
}

Border border_of(const Contact& contact, const MountedWheel& wheel, const Controls& controls) {
  const bool sticks = contact.grip == Grip::stick;
  return {sticks ? contact.static_friction : contact.dynamic_friction, controls.brake * wheel.brake_share};
}

double border_violation(const Eigen::Vector3d& force_in_wheel, const Eigen::Vector3d& normal_in_wheel,
                        const Border& border) {
  const Eigen::Vector3d force = surface_axes(normal_in_wheel).transpose() * force_in_wheel;
  const double load = -force.z();
  if (!(load > 0)) return 0;
  const double beyond_disc = std::hypot(force.x(), force.y()) - border.friction * load;
  const double beyond_band = std::abs(force.x()) - border.brake;
  return std::max({0.0, beyond_disc, beyond_band}) / load;
}

AskedForce ContactLaw::at(const BodyState& end) const {
  const Frame frame = frame_of(end, rotation_of(end.world_from_body), wheel_, controls_);
  const Eigen::Matrix3d wheel_axes = world_from_wheel(frame);
  const Eigen::Vector3d pebble = vector_of(contact_.pebble_in_world);
  const Eigen::Vector3d arm = pebble - vector_of(frame.position_in_world);
  const Eigen::Vector3d p = wheel_axes.transpose() * arm;
  const Wheel& wheel = wheel_.wheel;
  const Eigen::Vector3d relative_velocity = vector_of(contact_.pebble_velocity_in_world) -
                                            vector_of(frame.velocity_in_world) -
                                            end.angular_velocity_in_world.cross(arm);
  const Eigen::Vector3d w = wheel_axes.transpose() * relative_velocity;
  const Eigen::Vector3d springs(wheel.k_xy, wheel.k_xy, wheel.k_z),
      dampers(wheel.d_xy, wheel.d_xy, wheel.d_z);
  const Eigen::Vector3d stretch(p.x(), p.y(), p.z() - wheel.z_zero);
  const Eigen::Vector3d of_springs_in_wheel = springs.cwiseProduct(stretch);
  const Eigen::Vector3d of_dampers_in_wheel = dampers.cwiseProduct(w);
  const Eigen::Vector3d on_pebble_in_wheel = of_springs_in_wheel + of_dampers_in_wheel;

  const Eigen::Matrix3d wheel_from_surface =
      surface_axes(wheel_axes.transpose() * vector_of(contact_.normal_in_world));
  const Eigen::Matrix3d world_from_surface = wheel_axes * wheel_from_surface;
  AskedForce result;
  result.asked = -(wheel_from_surface.transpose() * on_pebble_in_wheel);
  const Eigen::Vector3d stiffness = -(h_ * springs + dampers);
  result.stiffness = wheel_from_surface.transpose() * stiffness.asDiagonal() * wheel_from_surface;
  result.jacobian << world_from_surface.transpose(),
      -world_from_surface.transpose() * cross_matrix(pebble - end.position_in_world);
  const Eigen::DiagonalMatrix<double, 3> tilt(1, 1, 0), heading(0, 0, 1);
  result.turning.rightCols<3>() =
      h_ *
      (cross_matrix(wheel_from_surface.transpose() * of_springs_in_wheel) * tilt -
       cross_matrix(wheel_from_surface.transpose() * of_dampers_in_wheel) * heading) *
      world_from_surface.transpose();
  const Eigen::Vector3d reach = pebble.cwiseAbs() + vector_of(frame.position_in_world).cwiseAbs();
  result.granularity = wheel_from_surface.transpose().cwiseAbs() *
                       springs.cwiseAbs().cwiseProduct(wheel_axes.transpose().cwiseAbs() * reach);
  result.border = border_of(contact_, wheel_, controls_);
  return result;
}

}  // namespace groundtruth::rig
