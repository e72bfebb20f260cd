#pragma once
// Implementations with one mistake each. The oracle is right to be trusted if it finds every one of them.

#include <functional>
#include <string_view>
#include <vector>

#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::planted {

enum class Kind { entry, clip, step };

// Which asks show the mistake?
enum class Reach {
  common,   // many of those that are anywhere
  special,  // those of a plain property: a range, a slip, a seam, a paint
  tied,     // those that meet a border between two answers exactly
  extreme   // those of numbers or shapes that hardly anybody asks about
};

// Answers the asks about one scene.
using Answering = std::function<Answer(const Ask&)>;
using Prepare = std::function<Answering(const Scene&)>;

struct Bug {
  std::string_view name;
  Kind kind;
  Reach reach;
  std::string_view mistake;  // one line
  Prepare on;
};

// Each list is a file of its own, named after it.
std::vector<Bug> segment_bugs();    // the ask's segment and range
std::vector<Bug> number_bugs();     // lambda and arithmetic
std::vector<Bug> search_bugs();     // the recursion over the expression
std::vector<Bug> face_bugs();       // which leaf, which normal
std::vector<Bug> shape_bugs();      // reading the expression
std::vector<Bug> misread_bugs();    // reading what is rare
std::vector<Bug> numbering_bugs();  // leaf numbers
std::vector<Bug> material_bugs();   // painting
std::vector<Bug> clip_bugs();       // the clip
std::vector<Bug> border_bugs();     // the clip's comparisons
std::vector<Bug> motion_bugs();     // a step: frames, springs, damping
std::vector<Bug> state_bugs();      // a step: which comes next
std::vector<Bug> landing_bugs();    // a step: where a strut meets the ground

// All of them, in this order.
const std::vector<Bug>& all_bugs();

std::string_view name(Kind kind);
std::string_view name(Reach reach);

}  // namespace groundtruth::planted
