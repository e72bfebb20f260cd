// With a tolerance in metres, what a shape between S - tau and S + tau answers is accepted.

#include <cmath>
#include <random>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "judging.hpp"

namespace groundtruth::judge {
namespace {

constexpr double tau = 0.01;
const Tolerance tolerance{tau, 1};

double length_of(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

// The shape with each offset changed by what `change` makes of its half-space.
template <typename Change>
Shape with_offsets(const Shape& shape, Change& change) {
  Shape result = shape;
  const auto all = [&](std::vector<Shape>& operands) {
    for (Shape& operand : operands) operand = with_offsets(operand, change);
  };
  if (auto* leaf = std::get_if<HalfSpace>(&result.expression)) leaf->offset += change(*leaf);
  if (auto* of = std::get_if<Union>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Intersection>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Covered>(&result.expression))
    of->over = std::make_shared<const Shape>(with_offsets(*of->over, change));
  if (auto* of = std::get_if<Painted>(&result.expression))
    of->over = std::make_shared<const Shape>(with_offsets(*of->over, change));
  return result;
}

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> built;
    for (const char* name : {"house", "ramp", "degenerate", "nested"}) {
      const auto pack = cases::find_builtin_scene(name)->build();
      for (std::size_t part = 0; part < pack.size(); part += 3) built.push_back(pack[part]);
    }
    return built;
  }();
  return all;
}

const Scene& scene_number(std::size_t index) { return scenes()[index % scenes().size()]; }

EntryAsk entry_ask(const Scene& scene, std::uint64_t seed, std::uint64_t index) {
  return std::get<EntryAsk>(cases::AskSource(scene, seed, {1, 0, 0}).ask_at(index).ask);
}

RC_GTEST_PROP(MovedPlanes, WhatALessMovedShapeAnswersIsAccepted, (std::size_t index, std::uint64_t seed)) {
  const Scene& scene = scene_number(index);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(-0.999, 0.999);
  auto change = [&](const HalfSpace& leaf) { return part(random) * tau * length_of(leaf.normal); };
  const Scene moved{scene.materials, with_offsets(scene.shape, change)};
  const auto exact = implementations::make_engine("exact")->on(moved);
  const Judge judge(scene, tolerance);
  for (std::uint64_t i = 0; i < 10; ++i) {
    const EntryAsk ask = entry_ask(scene, seed, i);
    RC_ASSERT(judge.judge(ask, exact->answer(ask).answer).explanation == std::string());
  }
}

}  // namespace
}  // namespace groundtruth::judge
