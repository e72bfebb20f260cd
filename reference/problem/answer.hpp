#pragma once
// What is answered (SPEC sections 3 to 5 and 8).

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/shape.hpp>

namespace groundtruth {

// No point of the segment's range lies in the solid.
struct Miss {
  bool operator==(const Miss&) const = default;
};

// The range starts in the topological interior of the solid.
struct Inside {
  double lambda = 0;
  bool operator==(const Inside&) const = default;
};

// The solid is entered, or stood on, at a face.
struct Border {
  double lambda = 0;
  Leaf leaf = 0;
  Vector normal_in_world{};               // the leaf's, as written
  std::optional<MaterialIndex> material;  // absent: none
  bool operator==(const Border&) const = default;
};

using EntryAnswer = std::variant<Miss, Inside, Border>;

// A well-formed ask that has no answer, and why (SPEC section 5: a contact without friction, a result
// outside the range of doubles).
struct Refusal {
  std::string reason;
  bool operator==(const Refusal&) const = default;
};

// The surface is too steep for an orientation on it to mean anything.
struct TooSteep {
  bool operator==(const TooSteep&) const = default;
};

struct Clipped {
  Grip grip = Grip::stick;
  Vector force_in_wheel{};  // N
  bool operator==(const Clipped&) const = default;
};

using ClipAnswer = std::variant<TooSteep, Clipped, Refusal>;

struct Stepped {
  WheelState state;
  Vector force_on_frame_in_world{};  // N; acts at the pebble
  bool operator==(const Stepped&) const = default;
};

// Outcomes that leave the state as it was, with no force: the caller decides.
enum class StepFailure { wheel_broken, surface_too_steep, surface_gave_way };

using StepAnswer = std::variant<Stepped, StepFailure, Refusal>;

using Answer = std::variant<EntryAnswer, ClipAnswer, StepAnswer>;

// Numbers that lie between two decimals, for whoever wants more digits than a double holds.
struct Enclosure {
  std::string quantity;  // "lambda", "force[0]", "state.pebble[2]", ...
  std::string lower;     // decimal, <= the exact value
  std::string upper;     // decimal, >= the exact value; equal to `lower` iff that is the exact value
};

// What an exact engine adds to an answer.
struct Evidence {
  std::string lambda_exact;      // "1/4" in lowest terms, "1" for 1; empty if the answer has no lambda
  std::vector<Leaf> admissible;  // ascending; empty unless the answer is on a border
  std::vector<Enclosure> enclosures;
};

}  // namespace groundtruth
