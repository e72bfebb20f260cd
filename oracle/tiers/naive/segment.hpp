#pragma once
// A segment among planes.

#include <optional>

#include <groundtruth/tiers/naive/solid.hpp>

namespace groundtruth::tiers::naive {

// A parameter, and the plane that is crossed there; none: the range's first. Places of planes that are
// written alike are equal whatever the arithmetic; that lets intervals decide more.
template <class Real>
struct Place {
  Real lambda;
  const Node<Real>* plane = nullptr;
};

template <class Real>
bool is_known_to_equal(const Place<Real>& a, const Place<Real>& b) {
  return a.plane == b.plane || (a.plane && b.plane && a.plane->written == b.plane->written);
}

template <class Real>
bool is_later(const Place<Real>& a, const Place<Real>& b) {
  return !is_known_to_equal(a, b) && a.lambda > b.lambda;
}

enum class Side { inside, on, outside };

template <class Real>
class Segment {
 public:
  Segment(const Vector3<Real>& from, const Vector3<Real>& to, const Real& first, const Real& last)
      : from_(from), direction_(minus(to, from)), first_(first), last_(last) {
    at_first_ = at(first);
    at_last_ = at(last);
  }

  const Vector3<Real>& direction() const { return direction_; }
  Place<Real> start() const { return {first_, nullptr}; }
  Vector3<Real> at(const Real& lambda) const { return plus(from_, times(lambda, direction_)); }

  // The first place at or after `from` that lies in the half-space.
  std::optional<Place<Real>> reach(const Node<Real>& plane, const Place<Real>& from) const {
    const Real a = distance(plane, at_first_), b = distance(plane, at_last_);
    const int before = sign_of(a), after = sign_of(b);
    if (before <= 0 && after <= 0) return from;
    if (before > 0 && after > 0) return std::nullopt;
    const Place<Real> crossed{before == 0 ? first_ : crossing(a, b), before == 0 ? nullptr : &plane};
    if (before > 0) return is_later(crossed, from) ? crossed : from;
    if (is_later(from, crossed)) return std::nullopt;
    return from;
  }

  // Of the plane's half-space.
  Side side(const Node<Real>& plane, const Place<Real>& place) const {
    const Real a = distance(plane, at_first_), b = distance(plane, at_last_);
    const int before = sign_of(a), after = sign_of(b);
    if (place.plane == nullptr) return side_of(before);
    if (before == after) return side_of(before);
    if (is_known_to_equal(place, {first_, &plane})) return Side::on;
    if (before == 0) return side_of(after);
    const Real crossed = after == 0 ? last_ : crossing(a, b);
    if (place.lambda == crossed) return Side::on;
    return side_of(place.lambda < crossed ? before : after);
  }

 private:
  static Side side_of(int distance) {
    return distance < 0 ? Side::inside : distance == 0 ? Side::on : Side::outside;
  }
  Real crossing(const Real& a, const Real& b) const { return first_ + a / (a - b) * (last_ - first_); }

  Vector3<Real> from_, direction_;
  Real first_, last_;
  Vector3<Real> at_first_, at_last_;
};

}  // namespace groundtruth::tiers::naive
