#pragma once
// The parts of the report's page. Private to this folder.

#include <string>

#include <groundtruth/report/measured.hpp>

namespace groundtruth::report {

std::string short_table(const Measured& measured);

// Figure, tables and worst asks of every study of a kind of ask.
std::string study_sections(const Measured& measured, tiers::AskKind kind);

std::string left_out_section(const Measured& measured);
std::string trajectory_section(const Measured& measured);
std::string stability_section(const Measured& measured);
std::string omission_section(const Measured& measured);

// "seed 1; CPU; compiler, flags; commit": what each figure bears.
std::string provenance_of(const Measured& measured);

}  // namespace groundtruth::report
