#include <groundtruth/rig/builtin_scenarios.hpp>

#include <algorithm>

#include <groundtruth/rig/builtin_parts.hpp>

namespace groundtruth::rig {

const std::vector<Scenario>& builtin_scenarios() {
  static const std::vector<Scenario> scenarios = [] {
    std::vector<Scenario> all;
    for (const auto add : {add_parked, add_sliding, add_stops, add_landings, add_extremes}) add(all);
    return all;
  }();
  return scenarios;
}

const Scenario* find_builtin_scenario(std::string_view name) {
  const auto& all = builtin_scenarios();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Scenario& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace groundtruth::rig
