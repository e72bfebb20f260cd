#pragma once
// Everything about one ask: what is answered, why, how near the next other decision is, and who would answer
// otherwise. Facts only; oracle/page tells and draws them. All decisions in here are exact.

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <groundtruth/cases/case.hpp>
#include <groundtruth/explanation/decision.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::explanation {

// A breakpoint, or all between two of them.
struct Stop {
  Rational from;
  Rational to;            // equal to `from` at a breakpoint
  std::vector<bool> lit;  // by node of the solid in play

  bool is_breakpoint() const { return from == to; }
};

struct EntryFacts {
  Segment segment;
  // What is left when every leaf that holds all of the segment, or none of it, and by more than `reach`
  // metres, is replaced by its value. Nothing in here changes that a plane moved by less could change.
  Solid in_play;
  std::size_t leaves_in_all = 0;
  std::optional<double> reach;  // absent: every leaf is in play
  std::vector<Stop> stops;
  Decision decision;
  Search search;
};

enum class ClipCase { too_steep, stick, band, corner, circle };

// Exactly rational: squares of forces in surface coordinates (SPEC section 4), N^2.
struct ClipFacts {
  ClipCase which = ClipCase::stick;
  Rational x_squared, y_squared;  // F'_x^2, F'_y^2
  int x_sign = 0, y_sign = 0;
  Rational normal_squared;  // N^2
  Rational friction, brake;
  Rational uprightness_squared,
      uprightness_needed_squared;  // (n_z / level part)^2 against t^2; unset if level is 0

  Rational disc_squared() const { return friction * friction * normal_squared; }
  Rational tangential_squared() const { return x_squared + y_squared; }
};

// One question of the wheel's step, in the order of SPEC section 5.
struct Question {
  std::string asks;  // "p_z >= z_max"
  std::string left;  // what is compared, to 20 digits
  std::string right;
  bool holds = false;
  std::string leads_to;  // where that leads: "free", "wheel broken"; empty: the next question
  std::string margin;    // by how much it would have to change to come out otherwise
};

struct StepFacts {
  std::vector<Question> questions;
  std::string from, to;  // states: "free", "stick", "slip", or an outcome
  // In the wheel frame. Unset if there is no contact before, or after.
  std::optional<RationalVector> pebble_before, pebble_after;
  std::optional<RationalVector> normal;  // of the ground at the pebble before; else at the one after
  RationalVector springs_force{};        // on the pebble, before it is clipped
  RationalVector force_after{};          // what is left of it, as answered
  std::optional<ClipFacts> clip;         // if it comes to that
  std::optional<EntryFacts> landing;     // of a free wheel: the strut against the ground
};

using Facts = std::variant<EntryFacts, ClipFacts, StepFacts>;

// What another would answer.
struct Opinion {
  std::string who;
  std::string line;        // its answer, JSON
  std::string difference;  // "differs in lambda", "is undecided"; empty: the same to the last bit
};

struct Explanation {
  cases::Case asked;
  Answer answer;  // the exact one
  Evidence evidence;
  std::string answer_line;
  std::string in_words;
  Facts facts;
  std::vector<Opinion> opinions;  // each engine, each tier that is none, and each erratum of SPEC section 7
};

Explanation explain(const cases::Case& asked);

EntryFacts facts_of(const Scene& scene, const Segment& segment);
ClipFacts facts_of(const ClipAsk& ask);
StepFacts facts_of(const Scene& scene, const StepAsk& ask, const StepAnswer& answer);

std::string_view name_of(ClipCase which);

}  // namespace groundtruth::explanation
