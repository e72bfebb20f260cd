#include <groundtruth/exact/wheel/motion.hpp>

namespace groundtruth::exact {

Rotation::Rotation(const Quaternion& q) {
  const Rational w(q[0]), x(q[1]), y(q[2]), z(q[3]);
  const Rational squared = w * w + x * x + y * y + z * z;
  const auto row = [&](const Rational& a, const Rational& b, const Rational& c) {
    return RationalVector(a / squared, b / squared, c / squared);
  };
  rows_ = {row(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
           row(2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
           row(2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z)};
}

RationalVector Rotation::operator()(const RationalVector& vector) const {
  return {rows_[0] * vector, rows_[1] * vector, rows_[2] * vector};
}

RationalVector Rotation::inverse(const RationalVector& vector) const {
  return rows_[0] * vector.x() + rows_[1] * vector.y() + rows_[2] * vector.z();
}

ContactInWheel seen_from_wheel(const Contact& contact, const Frame& frame, const Placement& placement) {
  const RationalVector pebble_in_world = to_rational(contact.pebble_in_world);
  const RationalVector arm_in_world = pebble_in_world - placement.origin_in_world;
  const RationalVector turning_in_world =
      CGAL::cross_product(to_rational(frame.angular_velocity_in_world), arm_in_world);
  const RationalVector velocity_in_world =
      to_rational(contact.pebble_velocity_in_world) - to_rational(frame.velocity_in_world) - turning_in_world;
  return {placement.to_wheel(pebble_in_world), placement.world_from_wheel.inverse(velocity_in_world),
          placement.world_from_wheel.inverse(to_rational(contact.normal_in_world))};
}

RationalVector spring_force(const Wheel& wheel, const ContactInWheel& contact) {
  const RationalVector& p = contact.pebble;
  const RationalVector& w = contact.pebble_velocity;
  const Rational k_xy(wheel.k_xy), k_z(wheel.k_z), d_xy(wheel.d_xy), d_z(wheel.d_z);
  return {k_xy * p.x() + d_xy * w.x(), k_xy * p.y() + d_xy * w.y(),
          k_z * (p.z() - Rational(wheel.z_zero)) + d_z * w.z()};
}

RootVector relocated(const Wheel& wheel, const ContactInWheel& contact, const RootVector& force,
                     const Rational& h) {
  const Rational k_xy(wheel.k_xy);
  const bool maps_back = wheel.relocation == Relocation::return_mapping;
  const Rational damping(maps_back ? wheel.d_xy : 0.0);
  const Rational damping_rate = damping / h;
  const Rational stiffness = k_xy + damping_rate;
  const auto level = [&](const RationalVector& vector) {
    return RationalVector(vector.x() / stiffness, vector.y() / stiffness, 0);
  };
  RootVector place = transformed(force, level);
  const RationalVector remembered = contact.pebble * damping_rate - contact.pebble_velocity * damping;
  place.u = place.u + level(remembered) + RationalVector(0, 0, Rational(wheel.z_min));
  return place;
}

}  // namespace groundtruth::exact
