#pragma once
// The errors of the source document, each a switch (SPEC section 7).
//
// With no erratum switched on, the engine of this folder is the plain recursive Phi in doubles, and all else
// as the contract has it. With all of them it is the source as literally as it can be run.
//
// Two rows of section 7 are no switches: `house-corners` is about data (a shape the source writes down), not
// about a formula; `mixed-frames` cannot be run as written, since it converts twice what it stored once.

#include <array>
#include <bitset>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace groundtruth::as_written {

enum class Erratum {
  single_pass_intersection,  // an intersection of half-spaces is gone through once
  normal_by_order,           // the first child to reach lambda gives the normal
  miss_is_plus_1000,         // a miss is the end of the range + 1000; the reader compares with that end
  surface_frame_sign,        // the surface frame turns by -phi_x, -phi_y
  band_test_wheel_x,         // the force is inside the brake band by its x in the wheel frame
  signed_normal_force,       // case 3 clips to mu F'_z, sign and all
  force_on_frame_sign,       // the frame gets the force that acts on the pebble
  no_liftoff,                // a wheel above its pebble has no force and keeps sticking
  tensile_contact,           // the ground may pull
  spring_relocation,         // Wheel::relocation is ignored: the spring alone says where a pebble slips to
  frame_rotation_ignored,    // Frame::angular_velocity_in_world is ignored
};

inline constexpr std::size_t number_of_errata = 11;

// Every erratum, in the order of SPEC section 7.
const std::array<Erratum, number_of_errata>& errata_in_order();

// As SPEC section 7 writes it: "single-pass-intersection".
std::string_view name_of(Erratum erratum);

// Nothing if no switch has that name.
std::optional<Erratum> erratum_named(std::string_view name);

// A set of errata. Errata{} is empty.
class Errata {
 public:
  Errata() = default;
  Errata(std::initializer_list<Erratum> members);

  void add(Erratum erratum);
  bool has(Erratum erratum) const;

  bool operator==(const Errata&) const = default;

 private:
  std::bitset<number_of_errata> members_;
};

Errata all_errata();

}  // namespace groundtruth::as_written
