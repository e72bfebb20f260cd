#include <chrono>

#include <groundtruth/fast/clip.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/step.hpp>
#include <groundtruth/implementations/adapters.hpp>
#include <groundtruth/implementations/compilation.hpp>

namespace groundtruth::implementations {
namespace {

class FastOnScene : public EngineOnScene {
 public:
  explicit FastOnScene(const Scene& scene) : scene_(fast::compile(scene)) {}

  Answered answer(const Ask& ask) const override {
    return {std::visit([this](const auto& kind) { return ask_fast(kind); }, ask), {}};
  }

 private:
  Answer ask_fast(const EntryAsk& ask) const { return fast::entry_point(scene_, ask); }
  Answer ask_fast(const ClipAsk& ask) const { return fast::clip(ask); }
  Answer ask_fast(const StepAsk& ask) const { return fast::step(scene_, ask); }

  fast::Scene scene_;
};

class FastEngine : public Engine {
 public:
  std::string name() const override { return "fast"; }
  std::unique_ptr<const EngineOnScene> on(const Scene& scene) const override {
    return std::make_unique<FastOnScene>(scene);
  }
};

}  // namespace

std::unique_ptr<const Engine> make_fast_engine() { return std::make_unique<FastEngine>(); }

Compilation compilation_of(const Scene& scene) {
  const auto start = std::chrono::steady_clock::now();
  const fast::Scene compiled = fast::compile(scene);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  Compilation compilation{compiled.solid().leaves.size(),
                          compiled.parts().cells.cells.size(),
                          compiled.parts().general.size(),
                          taken.count(),
                          {}};
  for (const fast::LeftOut& one : compiled.left_out())
    compilation.left_out.push_back({std::string(name_of(one.what)), one.count, one.why});
  return compilation;
}

}  // namespace groundtruth::implementations
