// With a tolerance in metres, what no shape between S - tau and S + tau answers is rejected. Checked by
// membership of sampled points in rationals, not by the judge's own engine.

#include <algorithm>
#include <array>
#include <random>

#include <boost/multiprecision/cpp_int.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "moved_planes.hpp"

namespace groundtruth::judge {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Rational, 3>;

// Whether the point lies at most `metres` above the plane.
bool is_reached(const HalfSpace& plane, const Point& point, double metres) {
  Rational height = -Rational(plane.offset);
  Rational squared_length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    height += Rational(plane.normal[i]) * point[i];
    squared_length += Rational(plane.normal[i]) * Rational(plane.normal[i]);
  }
  const Rational reach = Rational(metres) * Rational(metres) * squared_length;
  return metres > 0 ? height <= 0 || height * height <= reach : height <= 0 && height * height >= reach;
}

// Whether the shape contains the point when each offset is moved by `metres` lengths of its normal.
bool contains(const Shape& shape, const Point& point, double metres) {
  const auto in = [&](const Shape& part) { return contains(part, point, metres); };
  if (const auto* leaf = std::get_if<HalfSpace>(&shape.expression)) return is_reached(*leaf, point, metres);
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

bool is_off(const Scene& scene, double tau, const EntryAsk& ask, double lambda) {
  return !contains(scene.shape, point_at(ask, lambda), 1.001 * tau);
}

// Whether some sampled point from the start up to `end` lies in S - tau.
bool enters_before(const Scene& scene, double tau, const EntryAsk& ask, double end) {
  constexpr int samples = 16;
  for (int i = 0; i <= samples && end >= ask.lambda_first; ++i) {
    const double lambda = std::min(ask.lambda_first + (end - ask.lambda_first) * i / samples, end);
    if (contains(scene.shape, point_at(ask, lambda), -1.001 * tau)) return true;
  }
  return false;
}

bool is_refuted(const Scene& scene, double tau, const EntryAsk& ask, const EntryAnswer& got) {
  if (const auto* inside = std::get_if<Inside>(&got)) return is_off(scene, tau, ask, inside->lambda);
  const auto* border = std::get_if<Border>(&got);
  if (border == nullptr) return enters_before(scene, tau, ask, ask.lambda_last);
  const double slack = 1e-6 * (ask.lambda_last - ask.lambda_first);  // far more than the ulps allowed
  return enters_before(scene, tau, ask, border->lambda - slack) || is_off(scene, tau, ask, border->lambda);
}

bool is_local(const EntryAsk& ask) {
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max({size, std::fabs(ask.from[i]), std::fabs(ask.to[i])});
  const double range = std::max(std::fabs(ask.lambda_first), std::fabs(ask.lambda_last));
  return size < 1e4 && range < 10;  // so that an ulp of lambda moves a point by far less than tau
}

std::vector<HalfSpace> planes_of(const Shape& shape) {
  std::vector<HalfSpace> planes;
  auto note = [&](const HalfSpace& leaf) { return planes.push_back(leaf), 0.0; };
  with_offsets(shape, note);
  return planes;
}

// Where the segment meets the plane, from outside or from inside; anywhere else for a parallel one.
double crossing(const HalfSpace& plane, const EntryAsk& ask) {
  double at_start = -plane.offset;
  double rise = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    at_start += plane.normal[i] * ask.from[i];
    rise += plane.normal[i] * (ask.to[i] - ask.from[i]);
  }
  const double lambda = -at_start / rise;
  return lambda >= ask.lambda_first && lambda <= ask.lambda_last ? lambda : ask.lambda_last;
}

RC_GTEST_PROP(RefutedPoints, AreRejected, (std::size_t index, std::uint64_t seed)) {
  const Scene& scene = scene_number(index);
  const double tau = tau_number(seed);
  const Judge judge(scene, Tolerance{tau, 1});
  const std::vector<HalfSpace> planes = planes_of(scene.shape);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(0, 1);
  auto change = [&](const HalfSpace& leaf) {
    return 4 * (part(random) - 0.5) * tau * length_of(leaf.normal);
  };
  const auto too_far =
      implementations::make_engine("exact")->on({scene.materials, with_offsets(scene.shape, change)});
  for (std::uint64_t i = 0; i < 3; ++i) {
    const EntryAsk ask = entry_ask(scene, seed, i);
    if (!is_local(ask)) continue;
    std::vector<EntryAnswer> answers{Miss{}, std::get<EntryAnswer>(too_far->answer(ask).answer)};
    for (Leaf leaf = 0; leaf < planes.size(); ++leaf)
      answers.push_back(Border{crossing(planes[leaf], ask), leaf, planes[leaf].normal, cases::dry});
    for (const EntryAnswer& got : answers) {
      if (!is_refuted(scene, tau, ask, got)) continue;
      const Difference difference = judge.judge(ask, got).difference;
      RC_ASSERT(difference == Difference::hit_miss || difference == Difference::lambda ||
                difference == Difference::face);
    }
  }
}

bool is_out_of_reach(const HalfSpace& plane, double tau, const Point& point) {
  const HalfSpace turned{{-plane.normal[0], -plane.normal[1], -plane.normal[2]}, -plane.offset};
  const double reach = 1.001 * tau;
  return plane.normal == Vector{} || !is_reached(plane, point, reach) || !is_reached(turned, point, reach);
}

RC_GTEST_PROP(RefutedFaces, AreRejected, (std::size_t index, std::uint64_t seed)) {
  const Scene& scene = scene_number(index);
  const double tau = tau_number(seed);
  const Judge judge(scene, Tolerance{tau, 1});
  const std::vector<HalfSpace> planes = planes_of(scene.shape);
  for (std::uint64_t i = 0; i < 5; ++i) {
    const EntryAsk ask = entry_ask(scene, seed, i);
    const Answer exact = exact_answer(scene, ask);
    const auto* border = std::get_if<Border>(&std::get<EntryAnswer>(exact));
    if (border == nullptr || !is_local(ask)) continue;
    for (Leaf leaf = 0; leaf < planes.size(); ++leaf) {
      if (!is_out_of_reach(planes[leaf], tau, point_at(ask, border->lambda))) continue;
      const Border named{border->lambda, leaf, planes[leaf].normal, border->material};
      RC_ASSERT(judge.judge(ask, EntryAnswer{named}).difference == Difference::face);
    }
  }
}

}  // namespace
}  // namespace groundtruth::judge
