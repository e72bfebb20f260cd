#include "bug.hpp"

#include <array>

namespace groundtruth::planted {

const std::vector<Bug>& all_bugs() {
  static const std::vector<Bug> bugs = [] {
    std::vector<Bug> all;
    for (const auto list :
         {segment_bugs, number_bugs, search_bugs, face_bugs, shape_bugs, misread_bugs, numbering_bugs,
          material_bugs, clip_bugs, border_bugs, motion_bugs, state_bugs, landing_bugs}) {
      for (Bug& bug : list()) all.push_back(std::move(bug));
    }
    return all;
  }();
  return bugs;
}

std::string_view name(Kind kind) {
  constexpr std::array<std::string_view, 3> names{"entry", "clip", "step"};
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name(Reach reach) {
  constexpr std::array<std::string_view, 4> names{"common", "special", "tied", "extreme"};
  return names[static_cast<std::size_t>(reach)];
}

}  // namespace groundtruth::planted
