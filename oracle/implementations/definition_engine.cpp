#include <groundtruth/definition/clip.hpp>
#include <groundtruth/definition/entry_point.hpp>
#include <groundtruth/definition/step.hpp>
#include <groundtruth/implementations/adapters.hpp>

namespace groundtruth::implementations {
namespace {

class DefinitionOnScene : public EngineOnScene {
 public:
  explicit DefinitionOnScene(const Scene& scene) : scene_(scene) {}

  Answered answer(const Ask& ask) const override {
    return std::visit([this](const auto& kind) { return ask_definition(kind); }, ask);
  }

 private:
  Answered ask_definition(const EntryAsk& ask) const {
    definition::EntryFinding finding = definition::entry_point(scene_, ask);
    return {std::move(finding.answer), std::move(finding.evidence)};
  }
  Answered ask_definition(const ClipAsk& ask) const { return {definition::clip(ask), {}}; }
  Answered ask_definition(const StepAsk& ask) const { return {definition::step(scene_, ask), {}}; }

  definition::Scene scene_;
};

class DefinitionEngine : public Engine {
 public:
  std::string name() const override { return "definition"; }
  std::unique_ptr<const EngineOnScene> on(const Scene& scene) const override {
    return std::make_unique<DefinitionOnScene>(scene);
  }
};

}  // namespace

std::unique_ptr<const Engine> make_definition_engine() { return std::make_unique<DefinitionEngine>(); }

}  // namespace groundtruth::implementations
