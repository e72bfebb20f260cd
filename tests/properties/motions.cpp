#include <groundtruth/tests/properties/motions.hpp>

#include <cmath>

#include <groundtruth/tests/properties/shapes.hpp>

namespace groundtruth::properties {
namespace {

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector multiple(double factor, const Vector& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

Vector mirrored(Vector vector, std::size_t axis) {
  vector[axis] = -vector[axis];
  return vector;
}

// A rotation's axis, like any axial vector, is turned round in the other two coordinates.
Vector mirrored_axial(const Vector& vector, std::size_t axis) { return multiple(-1, mirrored(vector, axis)); }

}  // namespace

Vector product(const std::array<Vector, 3>& matrix, const Vector& vector) {
  return {dot(matrix[0], vector), dot(matrix[1], vector), dot(matrix[2], vector)};
}

Vector AffineMap::point(const Vector& x) const { return sum(product(matrix, x), shift); }

HalfSpace AffineMap::half_space(const HalfSpace& h) const {
  const auto& [a, b, c] = matrix;
  const double determinant = dot(a, cross(b, c));
  // The rows of the cofactor matrix, which is determinant * matrix^-T.
  const std::array<Vector, 3> cofactors{cross(b, c), cross(c, a), cross(a, b)};
  const Vector normal = multiple(std::copysign(1, determinant), product(cofactors, h.normal));
  return {normal, std::fabs(determinant) * h.offset + dot(normal, shift)};
}

EntryCase AffineMap::operator()(const EntryCase& c) const {
  EntryCase result{mapped(c.shape, [this](const HalfSpace& h) { return half_space(h); }), c.ask};
  result.ask.from = point(c.ask.from);
  result.ask.to = point(c.ask.to);
  return result;
}

std::array<Vector, 3> scaled_rotation(const Quaternion& q) {
  const auto& [w, x, y, z] = q;
  return {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

double squared_length(const Quaternion& q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

Quaternion quarter_turns(Dice& dice) {
  for (;;) {
    Quaternion q;
    for (double& part : q) part = dice.whole(-1, 1);
    const double length = squared_length(q);
    if (length == 1 || length == 2 || length == 4) return q;
  }
}

StepCase moved(const StepCase& c, const Quaternion& q, const Vector& shift) {
  const std::array<Vector, 3> matrix = scaled_rotation(q);
  const double scale = squared_length(q);
  const auto turned = [&](const Vector& vector) {
    const Vector scaled = product(matrix, vector);
    return Vector{scaled[0] / scale, scaled[1] / scale, scaled[2] / scale};
  };
  const auto point = [&](const Vector& x) { return sum(turned(x), shift); };
  StepCase result = c;
  result.shape = mapped(c.shape, [&](const HalfSpace& h) {
    const Vector normal = product(matrix, h.normal);
    return HalfSpace{normal, scale * h.offset + dot(normal, shift)};
  });
  Frame& frame = result.ask.frame;
  frame = {point(c.ask.frame.position_in_world), product(q, c.ask.frame.world_from_wheel),
           turned(c.ask.frame.velocity_in_world), turned(c.ask.frame.angular_velocity_in_world)};
  if (auto* contact = std::get_if<Contact>(&result.ask.state)) {
    contact->pebble_in_world = point(contact->pebble_in_world);
    contact->pebble_velocity_in_world = turned(contact->pebble_velocity_in_world);
    contact->normal_in_world = product(matrix, contact->normal_in_world);
  }
  return result;
}

StepCase enlarged(const StepCase& c, double factor) {
  StepCase result = c;
  result.shape = mapped(c.shape, [&](const HalfSpace& h) { return HalfSpace{h.normal, factor * h.offset}; });
  StepAsk& ask = result.ask;
  ask.brake *= factor;
  for (double* length : {&ask.wheel.z_min, &ask.wheel.z_zero, &ask.wheel.z_max}) *length *= factor;
  ask.frame.position_in_world = multiple(factor, ask.frame.position_in_world);
  ask.frame.velocity_in_world = multiple(factor, ask.frame.velocity_in_world);
  if (auto* contact = std::get_if<Contact>(&ask.state)) {
    contact->pebble_in_world = multiple(factor, contact->pebble_in_world);
    contact->pebble_velocity_in_world = multiple(factor, contact->pebble_velocity_in_world);
    if (contact->maximum_force) *contact->maximum_force *= factor;
  }
  return result;
}

StepCase mirrored(const StepCase& c, std::size_t axis) {
  StepCase result = c;
  result.shape = mapped(c.shape, [&](const HalfSpace& h) {
    return HalfSpace{mirrored(h.normal, axis), h.offset};
  });
  const Quaternion& q = c.ask.frame.world_from_wheel;
  const Vector turning = mirrored_axial({q[1], q[2], q[3]}, axis);
  Frame& frame = result.ask.frame;
  frame = {mirrored(frame.position_in_world, axis),
           {q[0], turning[0], turning[1], turning[2]},
           mirrored(frame.velocity_in_world, axis),
           mirrored_axial(frame.angular_velocity_in_world, axis)};
  if (auto* contact = std::get_if<Contact>(&result.ask.state)) {
    contact->pebble_in_world = mirrored(contact->pebble_in_world, axis);
    contact->pebble_velocity_in_world = mirrored(contact->pebble_velocity_in_world, axis);
    contact->normal_in_world = mirrored(contact->normal_in_world, axis);
  }
  return result;
}

}  // namespace groundtruth::properties
