#pragma once
// The faces that meet at a point, and why each may be named or not (SPEC section 3). A third way to find
// them: each plane's own cone directions, taken between neighbouring rays where the other planes cut it.

#include <vector>

#include <groundtruth/explanation/solid.hpp>

namespace groundtruth::explanation {

enum class Role {
  admissible,    // bounds the solid and is entered, or is started on
  thin,          // the solid is thinner than a face here; every face that stands and is entered may be named
  behind,        // the solid goes on behind it: a seam
  apart,         // the solid is not at this plane near the point, but for other planes
  stood_in_for,  // it bounds, but another face of the same plane stands there
  swallowed,     // the leaves elsewhere decide without it
  not_entered,   // it bounds, and the segment does not go into its half-space
  not_needed     // it stands where the solid is thin, or elsewhere, and is not entered
};

struct TiedFace {
  std::size_t plane = 0;  // its place in the solid
  Role role = Role::swallowed;
  bool entered = false;  // normal . direction < 0
};

struct Meeting {
  std::vector<TiedFace> faces;  // by leaf number
  bool interior = false;        // then none is admissible

  bool is_admissible(const TiedFace& face) const {
    return !interior && (face.role == Role::admissible || face.role == Role::thin);
  }
};

struct Arrival {
  RationalVector point;
  RationalVector direction;  // of the segment
  bool at_start = false;     // lambda = lambda_1: then entering does not count
};

// Requires that the solid contains the point.
Meeting meeting_at(const Solid& solid, const Arrival& arrival);

// One line, in words.
std::string_view reason_of(Role role);

}  // namespace groundtruth::explanation
