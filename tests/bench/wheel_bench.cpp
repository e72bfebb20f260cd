// Clips and steps: kinds of asks x engines, one thread. Times are per ask; "quick" is the part of the asks
// that fast decides in doubles, "slips" the part that slips.

#include <algorithm>
#include <map>
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
#include <groundtruth/fast/clip_decided.hpp>
#include <groundtruth/fast/step.hpp>
#include <groundtruth/fast/step_decided.hpp>
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

// What a brake and a force along and across the surface lead to, under a load of 10 kN.
struct Pull {
  std::string name;
  double along, across, brake;  // N
  double friction = 0.5;
};
const std::vector<Pull> pulls{{"stick", 1e3, 1e3, 1e4},
                              {"slip-1-band-edge", 2e3, 1e3, 500},
                              {"slip-2-corner", 6e4, 6e3, 500},
                              {"slip-3-circle", 6e3, 6e3, 1e5}};
// Of a wheel that stands straight and heads along an axis, so that many numbers are 0.
const std::vector<Pull> straight_pulls{{"straight-stick", 1e3, 0, 1e4},
                                       {"straight-roll", 1e3, 0, 0},
                                       {"straight-slip-1-band-edge", 2e3, 0, 500},
                                       {"straight-slip-3-circle", 6e3, 0, 1e5},
                                       {"straight-on-ice", 1e3, 0, 500, 0}};

// Of a row's asks.
using Shares = std::map<std::string, double>;

template <class Ask, class Answer>
void ask_all(const std::string& name, const std::vector<Ask>& asks, Answer answer,
             const Shares& shares = {}) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    std::size_t i = 0;
    for (auto _ : state) {
      benchmark::DoNotOptimize(answer(asks[i]));
      if (++i == asks.size()) i = 0;
    }
    for (const auto& [what, share] : shares) state.counters[what] = share;
  });
}

std::vector<ClipAsk> clips(const Pull& pull) {
  Chooser choose;
  std::vector<ClipAsk> asks(asks_per_set);
  for (ClipAsk& ask : asks) {
    ask.force_in_wheel = {pull.along * choose.between(0.9, 1.1), pull.across * choose.between(0.9, 1.1),
                          1e4 * choose.between(0.95, 1.05)};
    ask.normal_in_wheel = {choose.between(-0.01, 0.01), choose.between(-0.01, 0.01), -1};
    ask.friction = pull.friction;
    ask.brake = pull.brake;
  }
  return asks;
}
std::vector<ClipAsk> straight_clips(const Pull& pull) {
  std::vector<ClipAsk> asks = clips(pull);
  for (ClipAsk& ask : asks) ask.normal_in_wheel = {0, 0, -1};
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
                        pull.friction,
                        pull.friction,
                        1e7};
  }
  return asks;
}
// On a plane that rises along x.
std::vector<StepAsk> straight_contact_steps(const Pull& pull, double rise) {
  std::vector<StepAsk> asks = contact_steps(pull);
  for (StepAsk& ask : asks) {
    Frame& frame = ask.frame;
    auto& contact = std::get<Contact>(ask.state);
    frame.position_in_world[1] = contact.pebble_in_world[1] = 0;
    frame.position_in_world[2] += rise * frame.position_in_world[0];
    contact.pebble_in_world[2] = rise * contact.pebble_in_world[0];
    contact.normal_in_world = {-rise, 0, 1};
    frame.world_from_wheel = {0, 1, 0, 0};
    frame.velocity_in_world = {frame.velocity_in_world[0], 0, 0};
    frame.angular_velocity_in_world = {};
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

template <class Ask, class Is>
double share(const std::vector<Ask>& asks, Is is) {
  return static_cast<double>(std::ranges::count_if(asks, is)) / static_cast<double>(asks.size());
}

bool is_slip(const ClipAnswer& answer) {
  const auto* clipped = std::get_if<Clipped>(&answer);
  return clipped != nullptr && clipped->grip == Grip::slip;
}
bool is_slip(const StepAnswer& answer) {
  const auto* stepped = std::get_if<Stepped>(&answer);
  const auto* contact = stepped == nullptr ? nullptr : std::get_if<Contact>(&stepped->state);
  return contact != nullptr && contact->grip == Grip::slip;
}

// quick: no stage after the first has anything to do. slips: what the row's name may say.
template <class Ask, class Decide>
Shares shares_of(const std::vector<Ask>& asks, Decide decide) {
  return {
      {"quick", share(asks, [&](const Ask& ask) { return decide(ask).decisions == fast::Stage::doubles; })},
      {"slips", share(asks, [&](const Ask& ask) { return is_slip(decide(ask).answer); })}};
}

void register_clips(const std::string& kind, const std::vector<ClipAsk>& asks) {
  const std::string name = "clip/" + kind + "/";
  ask_all(
      name + "fast", asks, [](const ClipAsk& ask) { return fast::clip(ask); },
      shares_of(asks, [](const ClipAsk& ask) { return fast::decide_clip(ask); }));
  ask_all(name + "double", asks,
          [](const ClipAsk& ask) { return as_written::clip(ask, as_written::Errata{}); });
  ask_all(name + "exact", asks, [](const ClipAsk& ask) { return exact::clip(ask); });
}
void register_clips() {
  for (const Pull& pull : pulls) register_clips(pull.name, clips(pull));
  for (const Pull& pull : straight_pulls) register_clips(pull.name, straight_clips(pull));
}

struct Prepared {
  explicit Prepared(const Scene& scene) : compiled(fast::compile(scene)), plain(scene), exactly(scene) {}

  fast::Scene compiled;
  as_written::Scene plain;
  exact::Scene exactly;
};

class Steps {
 public:
  Steps(std::string ground, const Scene& scene)
      : ground_(std::move(ground)), with_(std::make_shared<Prepared>(scene)) {}

  void add(const std::string& kind, const std::vector<StepAsk>& asks) const {
    const std::string name = "step/" + ground_ + "/" + kind + "/";
    const auto with = with_;
    ask_all(
        name + "fast", asks, [=](const StepAsk& ask) { return fast::step(with->compiled, ask); },
        shares_of(asks, [&](const StepAsk& ask) { return fast::decide_step(with->compiled, ask); }));
    ask_all(name + "double", asks,
            [=](const StepAsk& ask) { return as_written::step(with->plain, ask, as_written::Errata{}); });
    ask_all(name + "exact", asks, [=](const StepAsk& ask) { return exact::step(with->exactly, ask); });
  }
  void add_level() const {
    for (const Pull& pull : pulls) add(pull.name, contact_steps(pull));
    add("free-hit", free_steps(0.1));
    add("free-miss", free_steps(1));
  }
  void add_straight(double rise) const {
    for (const Pull& pull : straight_pulls) add(pull.name, straight_contact_steps(pull, rise));
  }

 private:
  std::string ground_;
  std::shared_ptr<Prepared> with_;
};

Scene one_half_space(const Vector& normal) {
  const std::vector<Material> materials{{"dry", {{"rubber", {0.5, 0.4}}}, 1e7}};
  return {materials, cover(0, groundtruth::half_space(normal, 0))};
}

void register_steps() {
  const Steps level("half-space", one_half_space({0, 0, 1}));
  level.add_level();
  level.add_straight(0);
  Steps("slope", one_half_space({0.25, 0, 1})).add_straight(-0.25);
  Steps("runway-1000", cases::runway_of(1000)).add_level();
}

}  // namespace
}  // namespace groundtruth::bench

int main(int count, char** arguments) {
  using namespace groundtruth;
  bench::register_clips();
  bench::register_steps();
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
