#pragma once
// What counts as simpler, by value: whatever generator a value came from.

#include <rapidcheck.h>

#include <groundtruth/tests/properties/generators.hpp>
#include <groundtruth/tests/properties/shapes.hpp>

namespace groundtruth::properties {

// Simpler values, the simplest first. Following them always ends.
std::vector<double> simpler(double value);
std::vector<Shape> simpler(const Shape& shape);
std::vector<EntryCase> simpler(const EntryCase& c);
std::vector<ClipAsk> simpler(const ClipAsk& ask);
std::vector<StepCase> simpler(const StepCase& c);

// The generator of make(dice), which shrinks by simpler().
template <typename Make>
auto shrinking(Make make) {
  using Value = decltype(make(std::declval<Dice&>()));
  return rc::Gen<Value>([make](const rc::Random& random, int) {
    Dice dice(random);
    return rc::shrinkable::shrinkRecur(
        make(dice), [](const Value& value) { return rc::seq::fromContainer(simpler(value)); });
  });
}

}  // namespace groundtruth::properties
