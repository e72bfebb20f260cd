#pragma once
// What is worth aiming at in a scene: its convex pieces with their faces, edges and corners, and the seams
// between pieces. Everything is in doubles and approximate by contract; it is exact where planes are short
// dyadics that meet in short dyadics, which is what most scenes here are made of.

#include <array>
#include <cstddef>
#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cases {

// The planes of one intersection, or of one half-space that stands alone, each scaled by a power of two so
// that its normal's largest component is in [1, 2). Regions of paint count as pieces.
using Piece = std::vector<HalfSpace>;

// Two planes of different pieces that are opposite, exactly, where the pieces touch or nearly do.
struct Seam {
  std::size_t piece = 0;
  std::size_t plane = 0;  // in the piece
  std::size_t other_piece = 0;
};

struct Landmarks {
  std::vector<Piece> pieces;  // without planes of zero normal; never empty, nor is any piece
  std::vector<Seam> seams;
  Vector low{};   // a box of integers around the corners of the bounded pieces, as far as they lie
  Vector high{};  // within 10^9 m; low < high in each coordinate
  std::vector<Material> materials;
};

// Takes time proportional to the scene's size, one or two microseconds a leaf.
Landmarks survey(const Scene& scene);

// A point where three planes of a piece meet. Planes from `Piece::size()` on are those of the box around the
// scene, which stand in where a piece has too few corners of its own.
struct Corner {
  Vector point{};
  std::array<std::size_t, 3> planes{};
};

// A piece and its corners: those of its convex solid, or, if that is empty, those of its planes. A corner in
// which more than three planes meet stands there once for each three of them. Of pieces with more than 12
// planes only the first 12 count.
struct DetailedPiece {
  std::vector<HalfSpace> planes;  // of the piece, then of the box around the scene
  std::size_t own_planes = 0;
  std::vector<Corner> corners;  // not empty
};

DetailedPiece detail(const Landmarks& landmarks, std::size_t piece);

}  // namespace groundtruth::cases
