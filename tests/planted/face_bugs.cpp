// Mistakes about which face is met, where several meet.

#include <algorithm>
#include <limits>
#include <optional>

#include "ways.hpp"

namespace groundtruth::planted {
namespace {

// The leaves whose planes hold the point and that are entered; all that hold it, where the range starts.
std::vector<Leaf> reached(const Meeting& meeting) {
  std::vector<Leaf> leaves = meeting.tied();
  if (!meeting.at_start) std::erase_if(leaves, [&](Leaf leaf) { return !(meeting.advance(leaf) < 0); });
  return leaves;
}

EntryAnswer first_reached(const Meeting& meeting) {
  const std::vector<Leaf> leaves = reached(meeting);
  return leaves.empty() ? meeting.border : meeting.on(leaves.front());
}

EntryAnswer last_reached(const Meeting& meeting) {
  const std::vector<Leaf> leaves = reached(meeting);
  return leaves.empty() ? meeting.border : meeting.on(leaves.back());
}

EntryAnswer last_reached_of_three(const Meeting& meeting) {
  return planes_among(meeting, meeting.tied()) == 3 ? last_reached(meeting) : meeting.border;
}

EntryAnswer most_opposed(const Meeting& meeting) {
  const auto steepness = [&](Leaf leaf) {
    return meeting.advance(leaf) / static_cast<double>(length(numbers(meeting.half_space(leaf).normal)));
  };
  const std::vector<Leaf> leaves = reached(meeting);
  if (meeting.at_start || leaves.empty()) return meeting.border;
  return meeting.on(*std::min_element(leaves.begin(), leaves.end(),
                                      [&](Leaf a, Leaf b) { return steepness(a) < steepness(b); }));
}

EntryAnswer level_face(const Meeting& meeting) {
  if (meeting.at_start) return meeting.border;
  for (const Leaf leaf : meeting.tied()) {
    if (meeting.advance(leaf) == 0) return meeting.on(leaf);
  }
  return meeting.border;
}

EntryAnswer blended_over(const Meeting& meeting, std::size_t planes) {
  const std::vector<Leaf> leaves = reached(meeting);
  if (planes_among(meeting, leaves) != planes) return meeting.border;
  Border border = meeting.border;
  border.normal_in_world = {};
  for (const Leaf leaf : leaves) {
    for (std::size_t i = 0; i < 3; ++i) border.normal_in_world[i] += meeting.half_space(leaf).normal[i];
  }
  return border;
}

EntryAnswer blended_at_edges(const Meeting& meeting) { return blended_over(meeting, 2); }
EntryAnswer blended_at_corners(const Meeting& meeting) { return blended_over(meeting, 3); }

EntryAnswer facing_the_segment(const Meeting& meeting) {
  if (!(meeting.advance(meeting.border.leaf) > 0)) return meeting.border;
  Border border = meeting.border;
  for (double& component : border.normal_in_world) component = -component;
  return border;
}

EntryAnswer first_on_same_plane(const Meeting& meeting) {
  const HalfSpace& met = meeting.half_space(meeting.border.leaf);
  for (Leaf leaf = 0; leaf < meeting.border.leaf; ++leaf) {
    if (meeting.half_space(leaf) == met) return meeting.on(leaf);
  }
  return meeting.border;
}

// Of a sheet, {n.x <= d} and {-n.x <= -d}.
EntryAnswer back_of_sheet(const Meeting& meeting) {
  HalfSpace behind = meeting.half_space(meeting.border.leaf);
  behind.offset = -behind.offset;
  for (double& component : behind.normal) component = -component;
  for (const Leaf leaf : meeting.tied()) {
    if (meeting.half_space(leaf) == behind) return meeting.on(leaf);
  }
  return meeting.border;
}

EntryAnswer leaf_in_a_byte(const EntryAsk& ask, const Right& right) {
  EntryAnswer answer = right.entry(ask);
  if (auto* border = std::get_if<Border>(&answer)) border->leaf %= 256;
  return answer;
}

// An interior start on the plane of a seam.
EntryAnswer ghost_at_start(const EntryAsk& ask, const Right& right) {
  const EntryAnswer answer = right.entry(ask);
  const auto* inside = std::get_if<Inside>(&answer);
  if (inside == nullptr) return answer;
  const Meeting meeting(right, ask, Border{inside->lambda, 0, {}, std::nullopt});
  const std::vector<Leaf> leaves = meeting.tied();
  return leaves.empty() ? answer : meeting.on(leaves.front());
}

EntryAnswer inside_on_seams(const Meeting& meeting) {
  const bool is_seam = meeting.at_start && meeting.admissible.size() < meeting.tied().size();
  return is_seam ? EntryAnswer{Inside{meeting.border.lambda}} : meeting.border;
}

}  // namespace

std::vector<Bug> face_bugs() {
  using enum Reach;
  constexpr Kind entry = Kind::entry;
  return {
      {"first-reached-face", entry, tied, "the first face through the point that is entered: ghosts at seams",
       on_borders(first_reached)},
      {"last-reached-face", entry, tied, "the last face through the point that is entered: ghosts at seams",
       on_borders(last_reached)},
      {"last-of-three-faces", entry, tied, "as last-reached-face, only where exactly three planes meet",
       on_borders(last_reached_of_three)},
      {"most-opposed-face", entry, tied, "the face met most squarely, whether it bounds the solid or not",
       on_borders(most_opposed)},
      {"level-face", entry, tied, "a face along the segment counts as entered", on_borders(level_face)},
      {"blended-at-edges", entry, tied, "where two planes meet, the sum of their normals",
       on_borders(blended_at_edges)},
      {"blended-at-corners", entry, tied, "where three planes meet, the sum of their normals",
       on_borders(blended_at_corners)},
      {"normal-faces-segment", entry, tied, "the normal is turned against the segment",
       on_borders(facing_the_segment)},
      {"first-on-same-plane", entry, tied, "equal planes are one: the first one's leaf and material",
       on_borders(first_on_same_plane)},
      {"back-of-sheet", entry, tied, "a sheet without thickness is met from behind",
       on_borders(back_of_sheet)},
      {"leaf-in-a-byte", entry, special, "leaf numbers wrap at 256", answers(leaf_in_a_byte)},
      {"ghost-at-start", entry, tied, "a start inside, on the plane of a seam, is on a border",
       answers(ghost_at_start)},
      {"inside-on-seams", entry, tied, "a start on the surface, where a seam comes up, is inside",
       on_borders(inside_on_seams)},
  };
}

}  // namespace groundtruth::planted
