// Clips and steps: kinds of asks x engines, one thread. Times are per ask.

#include <algorithm>
#include <memory>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <groundtruth/as_written/clip.hpp>
#include <groundtruth/as_written/step.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/exact/clip.hpp>
#include <groundtruth/exact/step.hpp>
#include <groundtruth/fast/clip.hpp>
#include <groundtruth/fast/step.hpp>
#include <groundtruth/tests/fast/shapes.hpp>

namespace groundtruth::bench {
namespace {

constexpr std::size_t asks_per_set = 1024;

class Chooser {
 public:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

 private:
  std::mt19937_64 engine_{1};
};

// What a brake and a force along and across the surface lead to, under a load of 10 kN and friction 0.5.
struct Pull {
  std::string name;
  double along, across, brake;  // N
};
const std::vector<Pull> pulls{{"stick", 1e3, 1e3, 1e4},
                              {"slip-1-band-edge", 2e3, 1e3, 500},
                              {"slip-2-corner", 6e4, 6e3, 500},
                              {"slip-3-circle", 6e3, 6e3, 1e5}};

template <class Ask, class Answer>
void ask_all(const std::string& name, const std::vector<Ask>& asks, Answer answer) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(answer(asks[i]));
      if (++i == asks.size()) i = 0;
    }
  });
}

std::vector<ClipAsk> clips(const Pull& pull) {
  Chooser choose;
  std::vector<ClipAsk> asks(asks_per_set);
  for (ClipAsk& ask : asks) {
    ask.force_in_wheel = {pull.along * choose.between(0.9, 1.1), pull.across * choose.between(0.9, 1.1),
                          1e4 * choose.between(0.95, 1.05)};
    ask.normal_in_wheel = {choose.between(-0.01, 0.01), choose.between(-0.01, 0.01), -1};
    ask.friction = 0.5;
    ask.brake = pull.brake;
  }
  return asks;
}

// Half a metre above the ground at z = 0, upside down and not quite level, rolling along x.
StepAsk above_ground(Chooser& choose) {
  StepAsk ask;
  ask.wheel = {.k_xy = -1e5,
               .k_z = -5e4,
               .d_xy = -1e3,
               .d_z = -1.5e3,
               .z_min = 0.2,
               .z_zero = 0.7,
               .z_max = 0.7,
               .tyre = "rubber"};
  ask.frame.position_in_world = {choose.between(2, 9000), choose.between(-14, 14),
                                 choose.between(0.49, 0.51)};
  ask.frame.world_from_wheel = {choose.between(-0.01, 0.01), 1, choose.between(-0.01, 0.01),
                                choose.between(-0.01, 0.01)};
  ask.frame.velocity_in_world = {choose.between(0, 0.1), choose.between(0, 0.1), choose.between(-0.1, 0.1)};
  ask.frame.angular_velocity_in_world = {choose.between(-0.1, 0.1), choose.between(-0.1, 0.1), 0.1};
  ask.h = 0.001;
  return ask;
}

std::vector<StepAsk> contact_steps(const Pull& pull) {
  Chooser choose;
  std::vector<StepAsk> asks(asks_per_set);
  for (StepAsk& ask : asks) {
    ask = above_ground(choose);
    const Vector& b = ask.frame.position_in_world;
    ask.brake = pull.brake;
    // Springs take the pull.
    ask.state = Contact{Grip::slip,
                        {b[0] - pull.along / 1e5 * choose.between(0.9, 1.1),
                         b[1] + pull.across / 1e5 * choose.between(0.9, 1.1), 0},
                        {choose.between(0, 0.1), 0, 0},
                        {0, 0, 1},
                        0.5,
                        0.5,
                        1e7};
  }
  return asks;
}

std::vector<StepAsk> free_steps(double height) {
  Chooser choose;
  std::vector<StepAsk> asks(asks_per_set);
  for (StepAsk& ask : asks) {
    ask = above_ground(choose);
    ask.frame.position_in_world[2] += height;
  }
  return asks;
}

void register_clips() {
  for (const Pull& pull : pulls) {
    const std::string name = "clip/" + pull.name + "/";
    const auto asks = clips(pull);
    ask_all(name + "fast", asks, [](const ClipAsk& ask) { return fast::clip(ask); });
    ask_all(name + "double", asks,
            [](const ClipAsk& ask) { return as_written::clip(ask, as_written::Errata{}); });
    ask_all(name + "exact", asks, [](const ClipAsk& ask) { return exact::clip(ask); });
  }
}

struct Prepared {
  explicit Prepared(const Scene& scene) : compiled(fast::compile(scene)), plain(scene), exactly(scene) {}

  fast::Scene compiled;
  as_written::Scene plain;
  exact::Scene exactly;
};

void register_steps(const std::string& ground, const Scene& scene) {
  const auto with = std::make_shared<Prepared>(scene);
  const auto register_asks = [&](const std::string& kind, const std::vector<StepAsk>& asks) {
    const std::string name = "step/" + ground + "/" + kind + "/";
    ask_all(name + "fast", asks, [=](const StepAsk& ask) { return fast::step(with->compiled, ask); });
    ask_all(name + "double", asks,
            [=](const StepAsk& ask) { return as_written::step(with->plain, ask, as_written::Errata{}); });
    ask_all(name + "exact", asks, [=](const StepAsk& ask) { return exact::step(with->exactly, ask); });
  };
  for (const Pull& pull : pulls) register_asks(pull.name, contact_steps(pull));
  register_asks("free-hit", free_steps(0.1));
  register_asks("free-miss", free_steps(1));
}

Scene one_half_space() {
  const std::vector<Material> materials{{"dry", {{"rubber", {0.5, 0.4}}}, 1e7}};
  return {materials, cover(0, groundtruth::half_space({0, 0, 1}, 0))};
}

}  // namespace
}  // namespace groundtruth::bench

int main(int count, char** arguments) {
  using namespace groundtruth;
  bench::register_clips();
  bench::register_steps("half-space", bench::one_half_space());
  bench::register_steps("runway-1000", cases::runway_of(1000));
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
