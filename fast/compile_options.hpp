#pragma once
// What compiling a scene may leave out, and what it did leave out.

#include <bitset>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace groundtruth::fast {

// None changes an answer. Names in reports: name_of().
enum class Simplification {
  constants,              // everything, nothing and zero normals are folded away
  duplicates,             // an operand of the solid's union that is written like an earlier one
  empty_cells,            // intersections that certainly have no point
  buried_parts,           // cells that lie wholly inside a half-space of the solid's union
  redundant_half_spaces,  // faces of a cell that the cell certainly does not reach
  hidden_rules,           // materials under a material that covers the same faces
  known_materials,        // rules are not looked at where a cell bears one material, or none
  remote_paints,          // paints of a cell whose region certainly does not reach it
  hierarchy,              // the boxes over the parts; without it every part is looked at
  grid,                   // the squares over flat scenes, for short ranges
  written_solid,          // the solid as written, where its cells hold all that is asked for
};

inline constexpr std::size_t number_of_simplifications = 11;

std::string_view name_of(Simplification simplification);

// Which instructions answer asks; answers are the same bits.
enum class Instructions {
  best,      // the quickest that this processor has
  portable,  // those that every processor has which this library is built for
};

class CompileOptions {
 public:
  // All simplifications are on.
  CompileOptions() = default;

  CompileOptions& leave_off(Simplification simplification) {
    off_.set(static_cast<std::size_t>(simplification));
    return *this;
  }
  CompileOptions& answer_with(Instructions instructions) {
    instructions_ = instructions;
    return *this;
  }
  bool has(Simplification simplification) const { return !off_[static_cast<std::size_t>(simplification)]; }

  Instructions instructions() const { return instructions_; }

 private:
  Instructions instructions_ = Instructions::best;
  std::bitset<number_of_simplifications> off_;
};

// One kind of thing that was dropped, skipped or chosen.
struct LeftOut {
  Simplification what = Simplification::constants;
  std::size_t count = 0;  // of the things dropped, or of those that an index holds
  std::string why;
};

}  // namespace groundtruth::fast
