#pragma once
// Entry asks that follow each other through a scene: a wheel's next step is near its last.

#include <groundtruth/fast/neighbourhood.hpp>
#include <groundtruth/fast/range_ends.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::fast {

// A warm start: remembers what the scene holds around its last asks, so that the next one need look nowhere
// else.
// 1. entry_point(ask) is entry_point(scene, ask), bit for bit, whatever was asked before.
// 2. It pays where asks follow each other: a wheel's own follower, a strut's step. Asks that do not cost a
//    few nanoseconds more than without.
// 3. Allocates only where it looks around anew: when a range has left the surroundings of those before it.
// Not for concurrent asks: one follower for each thread, or wheel. The scene must outlive it.
class Follower {
 public:
  explicit Follower(const Scene& scene) : scene_(scene) {}

  // Requires what the ask requires (entry_point.hpp).
  EntryAnswer entry_point(const EntryAsk& ask);

 private:
  enum class Known { nothing, all, too_much };

  bool is_known(const RangeEnds& ends);
  void look_ahead(const RangeEnds& ends);

  const Scene& scene_;
  Known known_ = Known::nothing;  // of what lies in box_
  Box box_ = nowhere;
  Neighbourhood near_;
  RangeEnds last_;              // the last range that box_ did not hold
  unsigned near_in_a_row_ = 0;  // of those, how many were near the one before
  unsigned patience_ = 1;       // so many have to be before looking around is worth it
  unsigned served_ = 0;         // asks since it was looked around
};

}  // namespace groundtruth::fast
