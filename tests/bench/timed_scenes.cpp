#include <groundtruth/tests/bench/timed_scenes.hpp>

#include <cmath>

#include <groundtruth/cases/scene_builders.hpp>

namespace groundtruth::bench {

const std::vector<TimedScene>& timed_scenes() {
  static const std::vector<TimedScene> scenes{
      {"house", cases::house, {10, 10, -5, 0, 8}},
      {"runway", [] { return cases::runway_of(1000); }, {10000, 30, 0, 0, 1.5}},
      town("town-1k", 1000),
      town("town-100k", 100000),
      {"hills-20k", [] { return cases::hills_of(100); }, {800, 800, 0, 0, 5}},
  };
  return scenes;
}

const std::vector<AskKind>& ask_kinds() {
  static const std::vector<AskKind> kinds{{"strut", struts}, {"taxi", taxi}, {"long", long_ones}};
  return kinds;
}

// A house has 24 m by 24 m.
TimedScene town(const std::string& name, std::size_t houses) {
  const double side = 24 * std::ceil(std::sqrt(static_cast<double>(houses)));
  return {name, [houses] { return cases::town_of(houses, 1); }, {side, side, 0, 0, 8}};
}

}  // namespace groundtruth::bench
