#pragma once
// What `groundtruth stability` shows.

#include <string>
#include <vector>

#include <groundtruth/stability/extremes.hpp>
#include <groundtruth/stability/map.hpp>

namespace groundtruth::report {

// A letter a machine: rows are damping ratios, columns h omega; the theory's limit stands between them as |.
std::string table_of(const stability::Grid& grid, const std::vector<stability::Cell>& cells);

// A line a machine, with a heading.
std::string csv_of(const std::vector<stability::Cell>& cells);

// The same maps in colours, with the theory's line.
std::string svg_of(const stability::Grid& grid, const std::vector<stability::Cell>& cells);

// A row a kind of extreme: how many ran, and why the others did not.
std::string table_of(const std::vector<stability::Ordeal>& ordeals);

}  // namespace groundtruth::report
