#pragma once
// Error at the end of a motion against the time it took. Private to this folder.

#include <string>
#include <vector>

#include <groundtruth/report/measured.hpp>

namespace groundtruth::report {

// A panel a stiffness; in it a curve an integrator and relocation, a mark a length of step.
std::string trajectory_errors_plot(const std::string& motion,
                                   const std::vector<precision::TrajectoryRun>& runs);

}  // namespace groundtruth::report
