#pragma once
// What `groundtruth report` writes besides its page.

#include <string>
#include <utility>
#include <vector>

#include <groundtruth/precision/comparison.hpp>
#include <groundtruth/report/measured.hpp>

namespace groundtruth::report {

// One JSON object: all of it.
std::string json_of(const Measured& measured);

// A line a tier and study, with a heading.
std::string tiers_csv(const Measured& measured);
std::string left_out_csv(const Measured& measured);
std::string trajectories_csv(const Measured& measured);

// The figures by the names of their files.
std::vector<std::pair<std::string, std::string>> figures_of(const Measured& measured);

// What json_of() wrote, as far as reports are compared. Throws BadInput, or a line that says that the file
// cannot be read.
std::vector<precision::TierFigure> read_tier_figures(const std::string& file);

// The same of a report at hand.
std::vector<precision::TierFigure> tier_figures_of(const Measured& measured);

}  // namespace groundtruth::report
