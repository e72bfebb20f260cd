#pragma once
// The page that `groundtruth report` writes: one file, which fetches nothing and needs no script.

#include <string>

#include <groundtruth/report/measured.hpp>

namespace groundtruth::report {

std::string page_of(const Measured& measured);

// For the terminal: a row a scene and population.
std::string summary_of(const Measured& measured);

}  // namespace groundtruth::report
