#include "bug.hpp"
namespace groundtruth::planted {
std::vector<Bug> clip_bugs() { return {}; }
std::vector<Bug> border_bugs() { return {}; }
std::vector<Bug> motion_bugs() { return {}; }
std::vector<Bug> state_bugs() { return {}; }
std::vector<Bug> landing_bugs() { return {}; }
}  // namespace groundtruth::planted
