#pragma once
// The page that `groundtruth validate --html` writes: each group of failures explained on its smallest case.

#include <optional>
#include <string>
#include <vector>

#include <groundtruth/page/html_page.hpp>
#include <groundtruth/report/validation_report.hpp>
#include <groundtruth/validation/causes.hpp>

namespace groundtruth::cli {

// Of each cause its smallest failure; without causes, of each kind of failure the first. Their answer stands
// beside the exact one.
std::vector<page::Section> sections_of(const std::optional<validation::Causes>& causes,
                                       const std::vector<validation::Failure>& failures,
                                       const report::ReplayCommand& replay_command);

// Where each section stands in the file, a line each.
std::string places_of(const std::vector<page::Section>& sections, const std::string& file);

}  // namespace groundtruth::cli
