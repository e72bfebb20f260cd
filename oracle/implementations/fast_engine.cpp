#include <algorithm>
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
  explicit FastOnScene(const Scene& scene, const fast::CompileOptions& options = {})
      : scene_(fast::compile(scene, options)) {}

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
  Compilation compilation{compiled.leaf_count(),
                          compiled.parts().cells.cells.size(),
                          compiled.parts().general.size(),
                          taken.count(),
                          {}};
  for (const fast::LeftOut& one : compiled.left_out())
    compilation.left_out.push_back({std::string(name_of(one.what)), one.count, one.why});
  return compilation;
}

std::vector<std::string> simplification_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < fast::number_of_simplifications; ++i)
    names.emplace_back(name_of(static_cast<fast::Simplification>(i)));
  return names;
}

std::unique_ptr<const EngineOnScene> fast_without(const Scene& scene, const std::vector<std::string>& names) {
  const std::vector<std::string> known = simplification_names();
  fast::CompileOptions options;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (std::find(names.begin(), names.end(), known[i]) != names.end())
      options.leave_off(static_cast<fast::Simplification>(i));
  return std::make_unique<FastOnScene>(scene, options);
}

}  // namespace groundtruth::implementations
