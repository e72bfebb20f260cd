#include <bit>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/fast/clip.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/step.hpp>
#include <groundtruth/tests/fast/answer_bits.hpp>

namespace groundtruth {
namespace {

// FNV-1a over words.
class Hash {
 public:
  void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3; }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  template <std::size_t n>
  void add(const std::array<double, n>& numbers) {
    for (const double x : numbers) add(x);
  }
  void add(const std::string& text) {
    for (const char c : text) add(static_cast<std::uint64_t>(c));
  }

  void add(const EntryAsk& ask) {
    add(std::array{ask.lambda_first, ask.lambda_last}), add(ask.from), add(ask.to);
  }
  void add(const ClipAsk& ask) {
    add(ask.force_in_wheel), add(ask.normal_in_wheel);
    add(std::array{ask.friction, ask.brake, ask.min_uprightness});
  }
  void add(const StepAsk& ask) {
    const Wheel& wheel = ask.wheel;
    add(std::array{wheel.k_xy, wheel.k_z, wheel.d_xy, wheel.d_z, wheel.z_min, wheel.z_zero, wheel.z_max,
                   wheel.min_uprightness, ask.brake, ask.h});
    add(ask.frame.position_in_world), add(ask.frame.world_from_wheel);
    add(ask.frame.velocity_in_world), add(ask.frame.angular_velocity_in_world);
    add(ask.state);
  }

  void add(const Miss&) {}
  void add(const Inside& inside) { add(inside.lambda); }
  void add(const Border& border) {
    add(border.lambda), add(std::uint64_t{border.leaf}), add(border.normal_in_world);
    add(border.material ? std::uint64_t{*border.material} : ~std::uint64_t{});
  }
  void add(const Refusal& refusal) { add(refusal.reason); }
  void add(const TooSteep&) {}
  void add(const Clipped& clipped) {
    add(static_cast<std::uint64_t>(clipped.grip)), add(clipped.force_in_wheel);
  }
  void add(const Free&) {}
  void add(const Contact& contact) {
    add(static_cast<std::uint64_t>(contact.grip)), add(contact.pebble_in_world);
    add(contact.pebble_velocity_in_world), add(contact.normal_in_world);
    add(std::array{contact.static_friction, contact.dynamic_friction, contact.maximum_force.value_or(-1)});
  }
  void add(StepFailure failure) { add(static_cast<std::uint64_t>(failure)); }
  void add(const Stepped& stepped) { add(stepped.state), add(stepped.force_on_frame_in_world); }

  template <class... Kinds>
  void add(const std::variant<Kinds...>& one_of) {
    add(std::uint64_t{one_of.index()});
    std::visit([this](const auto& kind) { this->add(kind); }, one_of);
  }

  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const char* name : {"house", "ramp", "degenerate", "nested", "far-town"})
    for (Scene& scene : cases::find_builtin_scene(name)->build()) all.push_back(std::move(scene));
  all.push_back(cases::runway_of(50));
  all.push_back(cases::hills_of(12));
  all.push_back(cases::town_of(200, 1));
  for (std::uint64_t seed = 0; seed < 40; ++seed) all.push_back(cases::random_nested(seed, 6, 4));
  return all;
}

cases::AskMix only(AskKind kind) {
  return {kind == AskKind::entry ? 1u : 0u, kind == AskKind::clip ? 1u : 0u, kind == AskKind::step ? 1u : 0u};
}

struct AnsweredByFast {
  const fast::Scene& scene;
  Answer operator()(const EntryAsk& ask) const { return fast::entry_point(scene, ask); }
  Answer operator()(const ClipAsk& ask) const { return fast::clip(ask); }
  Answer operator()(const StepAsk& ask) const { return fast::step(scene, ask); }
};

}  // namespace

Bits bits_of_answers(AskKind kind, std::uint64_t count) {
  const std::vector<Scene> all = scenes();
  Hash asked, answered;
  for (std::size_t part = 0; part < all.size(); ++part) {
    const fast::Scene compiled = fast::compile(all[part]);
    const cases::AskSource source(all[part], cases::seed_of_part(100, part), only(kind));
    for (std::uint64_t i = 0; i < count / all.size(); ++i) {
      const Ask ask = source.ask_at(i).ask;
      asked.add(ask);
      answered.add(std::visit(AnsweredByFast{compiled}, ask));
    }
  }
  return {asked.value(), answered.value(), count / all.size() * all.size()};
}

}  // namespace groundtruth
