#pragma once
// What an ask was made to hit.

#include <cstdint>
#include <string_view>
#include <vector>

namespace groundtruth::cases {

enum class Flavour : std::uint8_t {
  entry_random,            // both ends anywhere in the scene's bounds
  entry_strut,             // 1 to 3 m, about vertical, above or through a face
  entry_lattice,           // both ends on a coarse lattice
  entry_through_face,      // through a point of a face
  entry_through_edge,      // through a point of an edge
  entry_through_corner,    // through a corner of a piece
  entry_through_crossing,  // through the meeting point of three planes that need not belong together
  entry_in_face_plane,     // both ends in the plane of a face
  entry_along_edge,        // along an edge
  entry_across_seam,       // through the seam between two pieces where it comes to the surface
  entry_along_seam,        // in the plane between two pieces
  entry_over_seam,         // in a face, across the seam to the next piece
  entry_start_on_face,     // the range starts on a feature, or inside
  entry_start_on_edge,
  entry_start_on_corner,
  entry_start_inside,
  entry_end_on_border,    // the range ends on a face, an edge or a corner
  entry_point,            // from = to
  entry_instant,          // lambda_first = lambda_last
  entry_from_afar,        // starts 10^4 to 10^10 m away
  entry_extreme_bits,     // coordinates from subnormal to 10^300
  clip_random,            // realistic forces and surfaces
  clip_disc_border,       // exactly on the disc's border
  clip_band_edge,         // exactly on the edge of the brake band
  clip_border_corner,     // exactly where band and disc meet
  clip_case_border_1_2,   // slips; |F'_y| = s
  clip_case_border_2_3,   // slips; B |F'_y| = |F'_x| s
  clip_wide_band,         // B = mu N
  clip_zeros,             // force, friction, brake, or the horizontal or normal part of the force is zero
  clip_steepness_limit,   // exactly as steep as is allowed
  clip_hopeless_surface,  // steep, upside down, or with a zero normal
  clip_extreme_bits,      // any finite numbers
  step_free_hit,          // a free wheel whose strut meets the ground
  step_free_miss,         // ... ends above it
  step_free_limits,       // ... touches it exactly at z_min or z_max
  step_free_in_ground,    // ... starts in it
  step_resting,           // in contact, with a force that the border bears
  step_skidding,          // in contact, with a force beyond the border
  step_turning,           // in contact, with angular velocity
  step_over_the_edge,     // skids where the face ends
  step_lands_on_feature,  // slips, and the strut through the new pebble meets a face, edge or corner exactly
  step_z_limits,          // p_z exactly z_min, z_zero or z_max
  step_no_pressure,       // F'_z exactly 0
  step_gives_way,         // F'_z exactly F_m
  step_border,            // the force exactly on the friction border, or on one between cases
  step_steepness_limit,   // the surface exactly as steep as is allowed
  step_stiff,             // springs and time steps far from realistic
  step_unknown_tyre,      // a tyre that no material knows
  step_extreme_bits,      // any finite numbers
};

// "entry/in-face-plane", "clip/disc-border", ...
std::string_view name(Flavour flavour);

const std::vector<Flavour>& all_flavours();

}  // namespace groundtruth::cases
