#pragma once
// The force of a wheel in contact as a function of the body's velocities at the end of a step, with its
// derivative: what an implicit step has to solve with. Private to this folder.
//
// Surface axes are the columns of Q (SPEC section 4), turned into the world; z points into the ground. Forces
// here act on the body.

#include <groundtruth/rig/body.hpp>

namespace groundtruth::rig {

using Jacobian = Eigen::Matrix<double, 3, 6>;

// What limits friction: a disc of radius friction * load, cut by the band |x| <= brake.
struct Border {
  double friction = 0;
  double brake = 0;
};

struct BorneForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Matrix3d derivative = Eigen::Matrix3d::Zero();  // by the force that springs and dampers ask for
};

// The nearest force that the ground can bear, nothing if it would have to pull: the load is -asked.z().
BorneForce borne(const Eigen::Vector3d& asked, const Border& border);

// The horizontal part with a disc that does not follow the load. Its derivative is symmetric.
BorneForce borne_by_disc(const Eigen::Vector3d& asked, double disc, double brake);

// Of one wheel, around some velocities u: the force asked for changes by (turning - stiffness * jacobian) du.
struct AskedForce {
  Eigen::Vector3d asked = Eigen::Vector3d::Zero();
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  // N s/m
  Jacobian jacobian = Jacobian::Zero();                 // velocity of the body at the pebble, in surface axes
  // As the body tilts, its wheel's springs turn against the ground. In a fast slide these are stretched by
  // metres, and a little tilt moves much force from the tangent to the normal.
  Jacobian turning = Jacobian::Zero();
  // By how much rounding of positions may move the force asked for: a spring of 10^15 N/m feels the last bit.
  Eigen::Vector3d granularity = Eigen::Vector3d::Zero();
  Border border;
};

// Of its surface axes.
inline Eigen::Matrix3d world_from_surface(const AskedForce& asked) {
  return asked.jacobian.leftCols<3>().transpose();
}

// Of a contact.
Border border_of(const Contact& contact, const MountedWheel& wheel, const Controls& controls);

// Friction of a force on the body beyond the border, in parts of its load; 0 if there is no load.
double border_violation(const Eigen::Vector3d& force_in_wheel, const Eigen::Vector3d& normal_in_wheel,
                        const Border& border);

// A wheel with its contact, over a step of h seconds that ends with the body at velocities `u`.
class ContactLaw {
 public:
  ContactLaw(const MountedWheel& wheel, const Contact& contact, const Controls& controls, double h)
      : wheel_(wheel), contact_(contact), controls_(controls), h_(h) {}

  // Beyond the strut's reach too: there it asks for a pull, which the ground does not bear.
  AskedForce at(const BodyState& end) const;

 private:
  const MountedWheel& wheel_;
  const Contact& contact_;
  const Controls& controls_;
  double h_;
};

}  // namespace groundtruth::rig
