#include <groundtruth/fast/crossing.hpp>

#include <groundtruth/fast/exact_stage/entry.hpp>

namespace groundtruth::fast {

RoundedLambda exact_crossing(const HalfSpace& leaf, const EntryAsk& ask) {
  return {exact_stage::crossing(leaf, ask), Stage::exact};
}

}  // namespace groundtruth::fast
