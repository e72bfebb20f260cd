#pragma once
// The plane in which a solid is shown, and the solid's cells in it. Private to this folder. Where something
// is far below what a double resolves, what is drawn still is right: all is measured from an exact centre.

#include <array>
#include <vector>

#include <groundtruth/explanation/explanation.hpp>

#include "markup.hpp"

namespace groundtruth::page {

using explanation::RationalVector;

// World point = centre + u across + v up, in metres.
struct CutPlane {
  Vector across{};  // of unit length
  Vector up{};
};

// Contains the segment's direction; shows upwards as up where it can, and the tied faces from the side.
CutPlane cut_through(const explanation::EntryFacts& facts);

// a u + b v + c <= 0
struct Trace {
  double a = 0, b = 0, c = 0;
};
Trace trace_of(const explanation::Plane& plane, const CutPlane& cut, const RationalVector& centre);

// A convex part of the solid within the window |u| <= half_width, |v| <= half_height; in (u, v).
struct Cell {
  std::vector<Dot> corners;
  std::optional<MaterialIndex> material;
};

struct Window {
  RationalVector centre;
  double half_width = 1;
  double half_height = 1;
};

std::vector<Cell> cells_of(const explanation::Solid& solid, const CutPlane& cut, const Window& window);

// The trace's piece within the window; empty if it misses it.
std::vector<Dot> piece_of(const Trace& trace, const Window& window);

}  // namespace groundtruth::page
