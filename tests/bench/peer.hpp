#pragma once
// Whoever answers the same entry asks, timed as a batch.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <groundtruth/fast/scene.hpp>
#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::bench {

// Answers all asks and returns how many hit, so that nothing can be left out.
using AnswerAll = std::function<std::size_t(std::span<const EntryAsk>)>;

// Slow: work grows with the number of half-spaces.
enum class Pace { quick, slow };

struct Peer {
  std::string name;
  AnswerAll answer;
  Pace pace = Pace::quick;
};

// Each builds what it needs of the scene when called.
Peer fast_one_by_one(std::shared_ptr<const fast::Scene> scene);
// A follower for each of three wheels, as the taxi asks come in turn.
Peer fast_warm(std::shared_ptr<const fast::Scene> scene);
Peer fast_in_bulk(std::shared_ptr<const fast::Scene> scene);
// fast's cells and index with the same loops, in plain doubles: no bound, no rounded lambda, no material.
// The scene must be a union of cells.
Peer without_certainty(std::shared_ptr<const fast::Scene> scene);
// One convex cell: the one-pass clip in plain doubles. Others: none, an empty function.
Peer one_pass_clip(const Scene& scene);
Peer naive_doubles(const Scene& scene);
Peer exact_engine(const Scene& scene);

// Empty functions where the library is not installed.
Peer embree(const Scene& scene, double reach);
Peer embree_packets(const Scene& scene, double reach);
Peer bullet(const Scene& scene, double reach);

}  // namespace groundtruth::bench
