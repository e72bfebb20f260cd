#pragma once
// The right answers about a scene, from which every mistake deviates.

#include <memory>

#include <groundtruth/implementations/engine.hpp>

#include "leaves.hpp"

namespace groundtruth::planted {

class Right {
 public:
  explicit Right(Scene scene);
  Right(const Right&) = delete;  // leaves() point into scene()

  const Scene& scene() const { return scene_; }
  const std::vector<PlacedLeaf>& leaves() const { return leaves_; }

  Answer answer(const Ask& ask) const { return fast_->answer(ask).answer; }
  EntryAnswer entry(const EntryAsk& ask) const { return std::get<EntryAnswer>(answer(ask)); }
  ClipAnswer clip(const ClipAsk& ask) const { return std::get<ClipAnswer>(answer(ask)); }
  StepAnswer step(const StepAsk& ask) const { return std::get<StepAnswer>(answer(ask)); }

  Evidence evidence(const EntryAsk& ask) const { return exact_->answer(ask).evidence; }

 private:
  Scene scene_;
  std::vector<PlacedLeaf> leaves_;  // point into scene_
  std::unique_ptr<const implementations::Engine> fast_engine_;
  std::unique_ptr<const implementations::Engine> exact_engine_;
  std::unique_ptr<const implementations::EngineOnScene> fast_;
  std::unique_ptr<const implementations::EngineOnScene> exact_;
};

// Several closures share one.
using SharedRight = std::shared_ptr<const Right>;

}  // namespace groundtruth::planted
