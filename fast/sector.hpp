#pragma once
// Sectors: the parts into which the planes through a point cut one of these planes. Not installed.

#include <Eigen/Geometry>
#include <groundtruth/fast/number.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::fast {

enum class Truth { no, yes, changes };

// The directions v in the plane of `face` just counterclockwise (seen from outside the face) of a line in
// that plane. `changes`: the half-space has the same plane as the face.
class Sector {
 public:
  // The whole plane. Requires that no half-space asked about has another plane.
  explicit Sector(const HalfSpace& face) : normal_(as<Wide>(face.normal)) {}

  // Beside the line in which the other's plane cuts the face's: `turn` = 1 or -1 tells which of the line's
  // two directions. Requires planes that differ.
  Sector(const HalfSpace& face, const HalfSpace& other, int turn)
      : normal_(as<Wide>(face.normal)), other_normal_(as<Wide>(other.normal)), turn_(turn) {}

  // Does v lie in the half-space through the point?
  Truth contains(const HalfSpace& half_space) const {
    const Vector3<Wide> n = as<Wide>(half_space.normal);
    const Vector3<Wide> line = normal_.cross(n);
    if (line.isZero(0)) return Truth::changes;
    // n . v for v along the other line; where that vanishes, for v turned away from it.
    const Wide along = normal_.dot(other_normal_.cross(n));
    const Wide side = along != 0 ? along : -line.dot(normal_.cross(other_normal_));
    return turn_ * side < 0 ? Truth::yes : Truth::no;
  }

  // Requires that the half-space has the face's plane.
  bool faces_alike(const HalfSpace& half_space) const { return normal_.dot(as<Wide>(half_space.normal)) > 0; }

 private:
  Vector3<Wide> normal_;
  Vector3<Wide> other_normal_ = Vector3<Wide>::Zero();
  int turn_ = 1;
};

inline bool have_one_plane(const HalfSpace& a, const HalfSpace& b) {
  return as<Wide>(a.normal).cross(as<Wide>(b.normal)).isZero(0);
}

}  // namespace groundtruth::fast
