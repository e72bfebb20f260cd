#pragma once
// The implementations that this program carries, behind one door.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::implementations {

struct Answered {
  Answer answer;
  Evidence evidence;  // empty from an engine that has none
};

// An engine with a scene prepared. Several threads may ask at once.
class EngineOnScene {
 public:
  virtual ~EngineOnScene() = default;
  virtual Answered answer(const Ask& ask) const = 0;
};

class Engine {
 public:
  virtual ~Engine() = default;
  virtual std::string name() const = 0;
  virtual std::unique_ptr<const EngineOnScene> on(const Scene& scene) const = 0;
};

// `name` is one of engine_names(), or "as-written:ERRATUM,..." with only these errata. `digits` > 0 asks
// engines that can for decimal enclosures. Absent: there is no such engine or erratum.
std::unique_ptr<const Engine> make_engine(std::string_view name, unsigned digits = 0);

// "exact", "definition", "fast", "double", "as-written".
std::vector<std::string> engine_names();

}  // namespace groundtruth::implementations
