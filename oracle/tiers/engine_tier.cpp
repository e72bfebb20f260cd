#include <utility>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/tiers/factories.hpp>

namespace groundtruth::tiers {
namespace {

using implementations::EngineOnScene;

class EngineTierOnScene : public TierOnScene {
 public:
  explicit EngineTierOnScene(std::unique_ptr<const EngineOnScene> engine) : engine_(std::move(engine)) {}
  TierAnswer answer(const Ask& ask) const override { return engine_->answer(ask).answer; }

 private:
  std::unique_ptr<const EngineOnScene> engine_;
};

class EngineTier : public Tier {
 public:
  EngineTier(std::unique_ptr<const implementations::Engine> engine, std::string description)
      : engine_(std::move(engine)), description_(std::move(description)) {}

  std::string name() const override { return engine_->name(); }
  std::string description() const override { return description_; }
  std::optional<Omitted> omission(AskKind) const override { return std::nullopt; }
  std::unique_ptr<const TierOnScene> on(const Scene& scene) const override {
    return std::make_unique<EngineTierOnScene>(engine_->on(scene));
  }

 private:
  std::unique_ptr<const implementations::Engine> engine_;
  std::string description_;
};

}  // namespace

MadeTier make_engine_tier(const std::string& engine, const std::string& description) {
  return std::make_unique<EngineTier>(implementations::make_engine(engine), description);
}

}  // namespace groundtruth::tiers
