#pragma once
// Points on the features of a scene, at random. They are exact where landmarks.hpp says that corners are:
// each is a combination of corners with weights that are short dyadics.

#include <groundtruth/cases/landmarks.hpp>
#include <groundtruth/cases/random.hpp>

namespace groundtruth::cases {

struct FacePoint {
  Vector point{};
  HalfSpace plane;  // of its face
};

struct EdgePoint {
  Vector point{};
  Vector direction{};  // of the edge; its length is the edge's
  HalfSpace plane;     // of one of the two faces
};

// A piece at random; the scene's first pieces, which are often its ground or its paint, are favoured.
DetailedPiece pick_piece(const Landmarks& landmarks, Random& random);

FacePoint on_a_face(const DetailedPiece& piece, Random& random);
EdgePoint on_an_edge(const DetailedPiece& piece, Random& random);
FacePoint at_a_corner(const DetailedPiece& piece, Random& random);

// A point of the convex solid, mostly of its interior.
Vector in_the_piece(const DetailedPiece& piece, Random& random);

// A point of a face whose normal points up, if a few tries find one; else of any face.
FacePoint foothold(const Landmarks& landmarks, Random& random);

// Where three planes of the scene meet that need not belong to one piece, but stand near each other in the
// expression; at a corner of a piece if the draw has no such point.
FacePoint at_a_crossing(const Landmarks& landmarks, Random& random);

// A point of the scene's bounds, enlarged by a quarter on all sides.
Vector in_bounds(const Landmarks& landmarks, Random& random);

// A point of the scene's bounds with coordinates that are multiples of 1/2^fraction_bits.
Vector lattice_point(const Landmarks& landmarks, int fraction_bits, Random& random);

// A vector of integers in [-8, 8], not zero, times a power of two in [1/8, 8]; along an axis now and then.
Vector short_direction(Random& random);

// The same, but with normal . direction >= 0.
Vector outward_direction(const Vector& normal, Random& random);

// A vector in the plane through the origin with this normal, exactly if the normal is short; not zero if the
// normal is not.
Vector direction_in_plane(const Vector& normal, Random& random);

}  // namespace groundtruth::cases
