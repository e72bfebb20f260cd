#pragma once
// What `groundtruth check` shows.

#include <string>
#include <vector>

#include <groundtruth/campaign/tally.hpp>

namespace groundtruth::report {

struct CheckedScene {
  std::string name;
  std::size_t leaves = 0;                // of all scenes of the pack
  std::vector<std::string> engines;      // the first is the exact one
  std::vector<campaign::Tally> tallies;  // one an engine
};

// A table: a row an engine, the time as a ratio to that of `double`; then how many asks were not put to an
// engine.
std::string table_of(const CheckedScene& checked);

// One line of JSON an engine.
std::string json_of(const CheckedScene& checked);

// The worst asks and the first disagreements of an engine, each with the command that shows the ask.
std::string findings_of(const CheckedScene& checked, std::size_t engine, const std::string& show_command);

}  // namespace groundtruth::report
