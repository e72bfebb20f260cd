// exact and definition say the same, answer and evidence, on everything that the generators can think of.
// (Ground and clip() throw Disagreement, with the lines that replay it.)

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

void ask(const EntryCase& c) {
  const Entered entered = Ground(c.shape).entry(c.ask);
  RC_CLASSIFY(entered.is_miss(), "miss");
  RC_CLASSIFY(entered.is_inside(), "inside");
  RC_CLASSIFY(entered.admissible.size() > 1, "several faces");
  // Never -0, nor anything but a double.
  if (entered.is_border()) RC_ASSERT(!std::signbit(entered.border().lambda) || entered.border().lambda < 0);
}

void ask(const ClipAsk& c) {
  const ClipAnswer answer = clip(c);
  RC_CLASSIFY(std::holds_alternative<TooSteep>(answer), "too steep");
  const auto* clipped = std::get_if<Clipped>(&answer);
  RC_CLASSIFY(clipped && clipped->grip == Grip::stick, "stick");
  RC_CLASSIFY(clipped && clipped->grip == Grip::slip, "slip");
}

void ask(const StepCase& c) {
  const StepAnswer answer = Ground(c.shape).step(c.ask);
  const auto* failure = std::get_if<StepFailure>(&answer);
  RC_CLASSIFY(failure && *failure == StepFailure::wheel_broken, "wheel broken");
  RC_CLASSIFY(failure && *failure == StepFailure::surface_too_steep, "surface too steep");
  RC_CLASSIFY(failure && *failure == StepFailure::surface_gave_way, "surface gave way");
  RC_CLASSIFY(std::holds_alternative<Refusal>(answer), "refusal");
  const auto* stepped = std::get_if<Stepped>(&answer);
  if (!stepped) return;
  const auto* contact = std::get_if<Contact>(&stepped->state);
  RC_CLASSIFY(!contact, "free");
  RC_CLASSIFY(contact && contact->grip == Grip::stick, "stick");
  RC_CLASSIFY(contact && contact->grip == Grip::slip, "slip");
}

RC_GTEST_PROP(Agreement, EntryOfLatticeSegmentsIntoNestedShapes, ()) { ask(*lattice_entries()); }
RC_GTEST_PROP(Agreement, EntryIntoShapesOfCubicNormals, ()) { ask(*cubic_entries()); }
RC_GTEST_PROP(Agreement, EntryWithAnyDoublesAndNeighbours, ()) { ask(*wild_entries()); }
RC_GTEST_PROP(Agreement, ClipOfSmallWholeNumbers, ()) { ask(*lattice_clips()); }
RC_GTEST_PROP(Agreement, ClipOnItsBorders, ()) { ask(*border_clips()); }
RC_GTEST_PROP(Agreement, ClipOfAnyDoubles, ()) { ask(*wild_clips()); }
RC_GTEST_PROP(Agreement, StepOfSmallWholeNumbers, ()) { ask(*lattice_steps()); }
RC_GTEST_PROP(Agreement, StepWithAnyDoublesAndNeighbours, ()) { ask(*wild_steps()); }

}  // namespace
}  // namespace groundtruth::properties
