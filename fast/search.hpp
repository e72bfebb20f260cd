#pragma once
// Where a range first meets the parts of a solid, as far as doubles can tell. Not installed.

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/scene.hpp>
#include <groundtruth/fast/sieved.hpp>

namespace groundtruth::fast {

struct Contender {
  Part part = 0;
  Meeting meeting;
};

using Contenders = boost::container::small_vector<Contender, 128>;

// Guarantees: if the range meets the solid, every part that contains its first point there is a contender,
// and that point lies at lower() <= s <= upper. Nothing left: a certain miss.
struct SearchResult {
  Contenders contenders;
  double upper = 1;
  bool starts_inside = false;  // certainly; contenders mean nothing then

  double lower() const;
  // Drops the contenders that start behind `upper`.
  void drop_late_ones();
};

// Only one contender, which certainly hits through one leaf alone: that leaf, and only that, is admissible.
// Else no_leaf.
Face sole_face(const Scene& scene, const Probe& probe, const SearchResult& result);

void search(const Scene& scene, const Probe& probe, SearchResult& result);

}  // namespace groundtruth::fast
