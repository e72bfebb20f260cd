#pragma once
// Vectors over any arithmetic.

#include <groundtruth/problem/vector.hpp>

namespace groundtruth::tiers::naive {

template <class Real>
struct Vector3 {
  Real x{}, y{}, z{};
};

template <class Real>
Vector3<Real> as(const Vector& v) {
  return {Real(v[0]), Real(v[1]), Real(v[2])};
}

template <class Real>
Vector3<Real> plus(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
Vector3<Real> minus(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
Vector3<Real> times(const Real& s, const Vector3<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
Real dot(const Vector3<Real>& a, const Vector3<Real>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <class Real>
Vector3<Real> cross(const Vector3<Real>& a, const Vector3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace groundtruth::tiers::naive
