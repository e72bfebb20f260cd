// With a tolerance in metres, what a shape between S - tau and S + tau answers is accepted.

#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "moved_planes.hpp"

namespace groundtruth::judge {
namespace {

RC_GTEST_PROP(MovedPlanes, WhatALessMovedShapeAnswersIsAccepted, (std::size_t index, std::uint64_t seed)) {
  const Scene& scene = scene_number(index);
  const double tau = tau_number(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> part(-0.999, 0.999);
  auto change = [&](const HalfSpace& leaf) { return part(random) * tau * length_of(leaf.normal); };
  const Scene moved{scene.materials, with_offsets(scene.shape, change)};
  const auto exact = implementations::make_engine("exact")->on(moved);
  const Judge judge(scene, Tolerance{tau, 1});
  for (std::uint64_t i = 0; i < 10; ++i) {
    const EntryAsk ask = entry_ask(scene, seed, i);
    RC_ASSERT(judge.judge(ask, exact->answer(ask).answer).explanation == std::string());
  }
}

}  // namespace
}  // namespace groundtruth::judge
