#pragma once
// Error against time, a mark a tier. Private to this folder.

#include <string>
#include <vector>

#include <groundtruth/report/measured.hpp>

namespace groundtruth::report {

// One panel a study, side by side. The upper part of a panel shows the tiers that took wrong decisions, or
// none: its height is the share of asks without a right answer. The lower part shows those that were always
// right: its height is the worst error.
std::string work_precision_plot(const std::string& title, const std::vector<const Study*>& studies);

}  // namespace groundtruth::report
