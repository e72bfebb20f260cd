#include <groundtruth/exact/clip.hpp>
#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/exact/step.hpp>
#include <groundtruth/implementations/adapters.hpp>

namespace groundtruth::implementations {
namespace {

class ExactOnScene : public EngineOnScene {
 public:
  ExactOnScene(const Scene& scene, exact::Digits digits) : scene_(scene), digits_(digits) {}

  Answered answer(const Ask& ask) const override {
    return std::visit([this](const auto& kind) { return ask_exact(kind); }, ask);
  }

 private:
  template <typename AnswerToAsk>
  static Answered answered(exact::Finding<AnswerToAsk> finding) {
    return {std::move(finding.answer), std::move(finding.evidence)};
  }
  Answered ask_exact(const EntryAsk& ask) const { return answered(exact::entry_point(scene_, ask, digits_)); }
  Answered ask_exact(const ClipAsk& ask) const { return answered(exact::clip(ask, digits_)); }
  Answered ask_exact(const StepAsk& ask) const { return answered(exact::step(scene_, ask, digits_)); }

  exact::Scene scene_;
  exact::Digits digits_;
};

class ExactEngine : public Engine {
 public:
  explicit ExactEngine(unsigned digits) : digits_(exact::Digits{digits}) {}
  std::string name() const override { return "exact"; }
  std::unique_ptr<const EngineOnScene> on(const Scene& scene) const override {
    return std::make_unique<ExactOnScene>(scene, digits_);
  }

 private:
  exact::Digits digits_;
};

}  // namespace

std::unique_ptr<const Engine> make_exact_engine(unsigned digits) {
  return std::make_unique<ExactEngine>(digits);
}

}  // namespace groundtruth::implementations
