#pragma once
// Wheels, orientations and places for step asks.

#include <groundtruth/cases/aim.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::cases {

Quaternion product(const Quaternion& p, const Quaternion& q);

// q v q^-1, rounded; exact for short v if q is one of right_angle_orientation().
Vector rotated(const Quaternion& q, const Vector& v);

// Turns the wheel's z about against the normal, with any yaw and a tilt of a few degrees. Seldom of unit
// length.
Quaternion upright_on(const Vector& normal_in_world, Random& random);

// Takes axes to axes; three times in four the wheel's z to the world's -z.
Quaternion right_angle_orientation(Random& random);

// A wheel as aeroplanes have them, for rubber or metal, with both relocations.
Wheel realistic_wheel(Random& random);

// One whose numbers are powers of two or sums of few: z_min = 1/4, z_zero = 1, z_max = 1 or 2.
Wheel short_wheel(Random& random);

// Positive, from 10^-4 to 10^-2 s; a power of two at times.
double time_step(Random& random);

// A point of the wheel frame at a point of the world.
Frame frame_with(const Quaternion& world_from_wheel, const Vector& point_in_wheel,
                 const Vector& point_in_world);

// A contact at the point, mostly with the friction of one of the scene's materials for the tyre.
Contact contact_at(const FacePoint& place, const Wheel& wheel, const Landmarks& landmarks, Random& random);

}  // namespace groundtruth::cases
