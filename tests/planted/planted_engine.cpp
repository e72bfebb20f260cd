#include "planted_engine.hpp"

#include <string>

namespace groundtruth::planted {
namespace {

using implementations::Answered;

class PlantedOnScene : public implementations::EngineOnScene {
 public:
  explicit PlantedOnScene(Answering answering) : answering_(std::move(answering)) {}
  Answered answer(const Ask& ask) const override { return {answering_(ask), {}}; }

 private:
  Answering answering_;
};

class PlantedEngine : public implementations::Engine {
 public:
  PlantedEngine(std::string_view name, Prepare prepare) : name_(name), prepare_(std::move(prepare)) {}
  std::string name() const override { return name_; }
  std::unique_ptr<const implementations::EngineOnScene> on(const Scene& scene) const override {
    return std::make_unique<PlantedOnScene>(prepare_(scene));
  }

 private:
  std::string name_;
  Prepare prepare_;
};

}  // namespace

std::unique_ptr<const implementations::Engine> make_engine_of(std::string_view name, Prepare prepare) {
  return std::make_unique<PlantedEngine>(name, std::move(prepare));
}

}  // namespace groundtruth::planted
