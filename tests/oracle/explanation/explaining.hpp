#pragma once
// Explanations held against the exact engine.

#include <cmath>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/corpus.hpp>
#include <groundtruth/explanation/explanation.hpp>
#include <groundtruth/implementations/engine.hpp>

#include <gtest/gtest.h>

namespace groundtruth::explanation {

inline Explanation explained(const std::string& id) {
  for (const cases::Case& one : cases::corpus())
    if (one.id == id) return explain(one);
  throw std::runtime_error("no such case: " + id);
}

inline Segment segment_of(const EntryAsk& ask) {
  return {rational(ask.from), minus(rational(ask.to), rational(ask.from)), Rational(ask.lambda_first),
          Rational(ask.lambda_last)};
}

// Lambda, inside or border, the canonical leaf and all admissible ones.
inline void expect_same_decision(const cases::Case& asked) {
  const auto exact = implementations::make_engine("exact")->on(asked.scene)->answer(asked.ask);
  const auto& answer = std::get<EntryAnswer>(exact.answer);
  const EntryFacts facts = facts_of(asked.scene, segment_of(std::get<EntryAsk>(asked.ask)));
  ASSERT_EQ(facts.decision.lambda.has_value(), !std::holds_alternative<Miss>(answer)) << asked.id;
  if (!facts.decision.lambda) return;
  EXPECT_EQ(facts.decision.lambda->str(), exact.evidence.lambda_exact) << asked.id;
  ASSERT_EQ(facts.decision.is_inside(), std::holds_alternative<Inside>(answer)) << asked.id;
  std::vector<Leaf> admissible;
  for (const TiedFace& face : facts.decision.meeting.faces)
    if (facts.decision.meeting.is_admissible(face))
      admissible.push_back(facts.in_play.planes[face.plane].leaf);
  EXPECT_EQ(admissible, exact.evidence.admissible) << asked.id;
  if (const auto* border = std::get_if<Border>(&answer)) {
    const RationalVector point = facts.segment.at(*facts.decision.lambda);
    EXPECT_EQ(facts.in_play.planes[*facts.decision.canonical].leaf, border->leaf) << asked.id;
    EXPECT_EQ(material_at(facts.in_play, *facts.decision.canonical, point), border->material) << asked.id;
  }
}

inline bool is_hit(const Scene& scene, const Ask& ask) {
  const auto exact = implementations::make_engine("exact")->on(scene)->answer(ask);
  return !std::holds_alternative<Miss>(std::get<EntryAnswer>(exact.answer));
}

// The shape with another offset for one leaf.
Shape with_offset(const Shape& shape, Leaf leaf, double offset);

}  // namespace groundtruth::explanation
