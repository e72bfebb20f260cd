#pragma once
// The cut through solid and segment, from all of the segment down to a few units in the last place of lambda.
// Private to this folder.

#include <string>
#include <vector>

#include <groundtruth/explanation/explanation.hpp>

namespace groundtruth::page {

struct CrossSection {
  std::string picture;                                  // SVG; a group of class "zoom" for each of `zooms`
  std::vector<std::string> zooms;                       // how wide each is
  std::vector<double> stops;                            // metres along the segment from the pictures' middle
  std::vector<std::optional<MaterialIndex>> materials;  // that can be seen
};

CrossSection cross_section_of(const explanation::EntryFacts& facts, double lambda);

}  // namespace groundtruth::page
