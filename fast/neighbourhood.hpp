#pragma once
// What a scene holds in a small box.

#include <cstdint>
#include <vector>

#include <groundtruth/fast/box.hpp>
#include <groundtruth/fast/scene.hpp>

namespace groundtruth::fast {

// Cells of a scene by other numbers, each without the half-spaces that hold in all of the box (Delta < 0):
// along a range in the box they are the scene (proofs-notes/scene-rewriting.md, section 3).
class Neighbourhood {
 public:
  static constexpr std::size_t most_cells = 16;

  // Forgets what it was. False, and nothing is held, if more than most_cells or a part that is no cell may
  // have points in the box, or if it goes beyond what the index's boxes know.
  bool look_around(const Scene& scene, const Box& box);

  const PackedCells& cells() const { return cells_; }

 private:
  bool add_indexed(const Scene& scene, const Box& box);
  bool add(const Scene& scene, const Box& box, Part part);

  PackedCells cells_;
  std::vector<std::uint32_t> open_, numbers_;  // nodes to look at; a cell's leaves
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace groundtruth::fast
