#pragma once
// The chapters of the corpus, and short spellings for what they are written with. Private to this folder.

#include <string>
#include <utility>
#include <vector>

#include <groundtruth/cases/case.hpp>
#include <groundtruth/cases/ground_materials.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::cases {

std::vector<Case> corpus_of_faces();
std::vector<Case> corpus_of_expressions();
std::vector<Case> corpus_of_paints();
std::vector<Case> corpus_of_ranges();
std::vector<Case> corpus_of_clips();
std::vector<Case> corpus_of_landings();
std::vector<Case> corpus_of_contacts();
std::vector<Case> corpus_of_slipping();

using Flags = std::vector<std::string>;

inline Scene ground(Shape shape) { return {ground_materials(), covered(dry, std::move(shape))}; }

// A plane z = 0 of dry ground.
inline Scene flat_ground() { return ground(half_space(0, 0, 1, 0)); }

}  // namespace groundtruth::cases
