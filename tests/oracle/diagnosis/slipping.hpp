#pragma once
// Suspects as subjects.

#include <memory>

#include <groundtruth/diagnosis/suspects.hpp>
#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::diagnosis {

// Answers with the suspect's error.
inline std::unique_ptr<const implementations::Engine> engine_of(const Suspect& suspect) {
  struct OnScene : implementations::EngineOnScene {
    OnScene(const Suspect& with, const Scene& of) : suspect(with), scene(of) {}
    implementations::Answered answer(const Ask& ask) const override {
      return {suspect.answer(scene, ask), {}};
    }
    Suspect suspect;
    Scene scene;
  };
  struct Slipping : implementations::Engine {
    explicit Slipping(const Suspect& with) : suspect(with) {}
    std::string name() const override { return suspect.name; }
    std::unique_ptr<const implementations::EngineOnScene> on(const Scene& scene) const override {
      return std::make_unique<OnScene>(suspect, scene);
    }
    Suspect suspect;
  };
  return std::make_unique<Slipping>(suspect);
}

}  // namespace groundtruth::diagnosis
