#pragma once
// A tier of the naive algorithms over a number type. Private to this folder: one small source file a number
// type instantiates it.

#include <string>
#include <utility>

#include <groundtruth/tiers/naive/entry.hpp>
#include <groundtruth/tiers/naive/step.hpp>
#include <groundtruth/tiers/numbers/interval.hpp>
#include <groundtruth/tiers/tier.hpp>

namespace groundtruth::tiers::naive {

inline constexpr const char* no_roots = "its numbers have no square roots";

template <class Real>
class NaiveOnScene : public TierOnScene {
 public:
  explicit NaiveOnScene(const Scene& scene) : ground_(ground_of<Real>(scene)) {}

  TierAnswer answer(const Ask& ask) const override {
    try {
      return std::visit([this](const auto& kind) { return Answer(this->answer_to(kind)); }, ask);
    } catch (const BoundsOverlap&) {
      return Undecided{};
    }
  }

 private:
  EntryAnswer answer_to(const EntryAsk& ask) const { return entry_point(ground_, ask); }
  ClipAnswer answer_to(const ClipAsk& ask) const {
    if constexpr (Arithmetic<Real>::has_roots)
      return clip<Real>(ask);
    else
      return Refusal{no_roots};
  }
  StepAnswer answer_to(const StepAsk& ask) const {
    if constexpr (Arithmetic<Real>::has_roots)
      return step(ground_, ask);
    else
      return Refusal{no_roots};
  }

  Ground<Real> ground_;
};

template <class Real>
class NaiveTier : public Tier {
 public:
  NaiveTier(std::string name, std::string description)
      : name_(std::move(name)), description_(std::move(description)) {}

  std::string name() const override { return name_; }
  std::string description() const override { return description_; }
  std::optional<Omitted> omission(AskKind kind) const override {
    if (kind == AskKind::entry || Arithmetic<Real>::has_roots) return std::nullopt;
    return Omitted{no_roots};
  }
  std::unique_ptr<const TierOnScene> on(const Scene& scene) const override {
    return std::make_unique<NaiveOnScene<Real>>(scene);
  }

 private:
  std::string name_, description_;
};

}  // namespace groundtruth::tiers::naive
