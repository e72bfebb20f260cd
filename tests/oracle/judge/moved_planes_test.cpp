// With a tolerance in metres: what a shape between S - tau and S + tau answers is accepted, and what none
// answers is rejected. Both are checked by membership of sampled points in rationals, not by the judge's own
// engine.

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <boost/multiprecision/cpp_int.hpp>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "judging.hpp"

namespace groundtruth::judge {
namespace {

using Rational = boost::multiprecision::cpp_rational;

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

using Point = std::array<Rational, 3>;

// Whether the shape contains the point when each offset is moved by `metres` lengths of its normal, give or
// take a part in 10^9.
bool contains(const Shape& shape, const Point& point, double metres) {
  const auto in = [&](const Shape& part) { return contains(part, point, metres); };
  if (const auto* leaf = std::get_if<HalfSpace>(&shape.expression)) {
    Rational height = -Rational(leaf->offset);
    for (std::size_t i = 0; i < 3; ++i) height += Rational(leaf->normal[i]) * point[i];
    return height <= Rational(metres * length_of(leaf->normal));
  }
  if (const auto* of = std::get_if<Union>(&shape.expression))
    return std::any_of(of->operands.begin(), of->operands.end(), in);
  if (const auto* of = std::get_if<Intersection>(&shape.expression))
    return std::all_of(of->operands.begin(), of->operands.end(), in);
  if (const auto* of = std::get_if<Covered>(&shape.expression)) return in(*of->over);
  if (const auto* of = std::get_if<Painted>(&shape.expression)) return in(*of->over);
  return std::holds_alternative<Everything>(shape.expression);
}

Point point_at(const EntryAsk& ask, double lambda) {
  Point point;
  for (std::size_t i = 0; i < 3; ++i)
    point[i] = Rational(ask.from[i]) + Rational(lambda) * (Rational(ask.to[i]) - Rational(ask.from[i]));
  return point;
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

// Sampled: some point before the answer's lambda lies in S - tau, or the answer's point lies outside of S +
// tau.
bool is_refuted(const Scene& scene, const EntryAsk& ask, const EntryAnswer& got) {
  const double slack = 1e-6;  // of the range: far more than the ulps allowed
  const double range = ask.lambda_last - ask.lambda_first;
  const auto* border = std::get_if<Border>(&got);
  const double end = border ? border->lambda - slack * range : ask.lambda_last;
  constexpr int samples = 64;
  for (int i = 0; i <= samples; ++i) {
    const double lambda = ask.lambda_first + (end - ask.lambda_first) * i / samples;
    if (lambda < ask.lambda_first || lambda > end) continue;
    if (contains(scene.shape, point_at(ask, lambda), -1.001 * tau)) return true;
  }
  if (border == nullptr) return false;
  const auto is_off = [&](double lambda) {
    return !contains(scene.shape, point_at(ask, lambda), 1.001 * tau);
  };
  return is_off(border->lambda);
}

bool is_local(const EntryAsk& ask) {
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max({size, std::fabs(ask.from[i]), std::fabs(ask.to[i])});
  const double range = std::max(std::fabs(ask.lambda_first), std::fabs(ask.lambda_last));
  return size < 1e4 && range < 10;  // so that an ulp of lambda moves a point by far less than tau
}

RC_GTEST_PROP(MovedPlanes, WhatSampledPointsRefuteIsRejected, (std::size_t index, std::uint64_t seed)) {
  const Scene& scene = scene_number(index);
  const Judge judge(scene, tolerance);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0, 1);
  auto grow = [&](const HalfSpace& leaf) { return 4 * (part(random) - 0.5) * tau * length_of(leaf.normal); };
  const auto too_far =
      implementations::make_engine("exact")->on({scene.materials, with_offsets(scene.shape, grow)});
  for (std::uint64_t i = 0; i < 10; ++i) {
    const EntryAsk ask = entry_ask(scene, seed, i);
    if (!is_local(ask)) continue;
    std::vector<EntryAnswer> answers{Miss{}, std::get<EntryAnswer>(too_far->answer(ask).answer)};
    for (Leaf leaf = 0; leaf < cases::leaf_count(scene.shape); ++leaf) {
      Border border{ask.lambda_first + part(random) * (ask.lambda_last - ask.lambda_first), leaf, {}, {}};
      answers.push_back(border);
    }
    for (const EntryAnswer& got : answers) {
      if (!is_refuted(scene, ask, got)) continue;
      const Difference difference = judge.judge(ask, got).difference;
      RC_ASSERT(difference == Difference::hit_miss || difference == Difference::lambda ||
                difference == Difference::face);
    }
  }
}

}  // namespace
}  // namespace groundtruth::judge
