#pragma once
// The shapes that small scenes are made of. Private to this folder.

#include <vector>

#include <groundtruth/cases/random.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth::cases {

// Mostly of one of the ground materials, each on its own, so that a wrong leaf shows as a wrong material too.
Shape of_some_material(Shape shape, Random& random);

// A plane through a lattice point near the origin, its normal of small integers.
Shape lattice_plane(Random& random);
// A box on the lattice of whole metres, of no thickness now and then.
Shape lattice_box(Random& random);

// A region to be painted.
Shape some_region(Random& random);

// Solids that touch.
Shape seam_row(Random& random);            // boxes in a row, their tops in one plane or nearly
Shape slab_stack(Random& random);          // slabs one on the other
Shape tiled_corner(Random& random);        // boxes around one edge or corner
Shape ground_with_things(Random& random);  // flat ground, and what stands on it

// Planes that meet.
Shape wedge(Random& random);            // two to four planes through one edge
Shape parallel_planes(Random& random);  // written at different lengths, met or joined
Shape spike(Random& random);            // three to seven planes through one corner, met or joined
Shape thin_sheets(Random& random);      // sheets, needles and points
Shape oblique_cell(Random& random);     // an intersection of planes of arbitrary doubles

// Expressions.
Shape nested_expression(Random& random);   // up to six levels
Shape wide_expression(Random& random);     // nine to forty-five operands
Shape many_sided_prism(Random& random);    // up to seventy planes around one axis, each a face of its own
Shape notched_box(Random& random);         // a box met with unions, so that it is not convex
Shape repeated_shape(Random& random);      // the same thing more than once, in other materials
Shape interleaved_unions(Random& random);  // each sends a segment on to the other's next gap
Shape odd_operands(Random& random);        // zero normals, constants, empty unions and intersections

}  // namespace groundtruth::cases
