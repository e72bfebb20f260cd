#pragma once
// What `groundtruth simulate` shows.

#include <string>

#include <groundtruth/rig/simulation.hpp>

namespace groundtruth::report {

// A heading, a short table, and the outcome in words.
std::string table_of(const rig::Scenario& scenario, const rig::Summary& summary);

// The same as one line of JSON.
std::string json_of(const rig::Scenario& scenario, const rig::Summary& summary);

}  // namespace groundtruth::report
