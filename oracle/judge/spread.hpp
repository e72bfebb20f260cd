#pragma once
// Vectors against the vectors that a tolerance allows. Private to this folder.

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::judge {

long double length(const Vector& vector);

// The smallest box, axis by axis, around one or more vectors.
class Spread {
 public:
  explicit Spread(const Vector& vector) : low_(vector), high_(vector) {}
  void include(const Vector& vector);

  // How far the vector lies outside the box, along the worst axis.
  long double distance_to(const Vector& vector) const;

 private:
  Vector low_;
  Vector high_;
};

// What a relative tolerance allows of a vector whose largest term has this size: nothing if it is 0; else at
// least four units of 2^-1074, which is what underflow costs.
long double allowed(double relative, long double scale);

}  // namespace groundtruth::judge
