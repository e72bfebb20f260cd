// entry_campaign SEED ASKS [SCENE...]: entry asks only, fast against exact, and the stages that decided.
// Exits with 1 on any difference.

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/fast/decided_entry.hpp>

namespace groundtruth {
namespace {

using Histogram = std::array<std::uint64_t, 5>;

struct Tally {
  Histogram place{}, lambda{}, material{};
  std::uint64_t asks = 0;
  std::uint64_t wrong = 0;
};

void print(const char* what, const Histogram& histogram) {
  std::printf("  %-9s none %8llu  doubles %8llu  double-double %8llu  exact %8llu\n", what,
              static_cast<unsigned long long>(histogram[0]), static_cast<unsigned long long>(histogram[1]),
              static_cast<unsigned long long>(histogram[3]), static_cast<unsigned long long>(histogram[4]));
}

void run_part(const Scene& scene, std::uint64_t seed, std::uint64_t asks, const std::string& name,
              Tally& tally) {
  const cases::AskSource source(scene, seed, {1, 0, 0});
  const fast::Scene compiled = fast::compile(scene);
  const exact::Scene prepared(scene);
  const auto count = [](Histogram& histogram, fast::Stage stage) {
    ++histogram[static_cast<std::size_t>(stage)];
  };
  for (std::uint64_t i = 0; i < asks; ++i) {
    const EntryAsk ask = std::get<EntryAsk>(source.ask_at(i).ask);
    const fast::DecidedEntry decided = fast::decide_entry(compiled, ask);
    ++tally.asks;
    count(tally.place, decided.place);
    count(tally.lambda, decided.lambda);
    count(tally.material, decided.material);
    if (decided.answer == exact::entry_point(prepared, ask).answer) continue;
    if (++tally.wrong < 4) {
      std::printf("  differs: %s seed %llu ask %llu\n", name.c_str(), static_cast<unsigned long long>(seed),
                  static_cast<unsigned long long>(i));
    }
  }
}

bool is_wanted(std::string_view name, int count, char** arguments) {
  for (int i = 3; i < count; ++i)
    if (name == arguments[i]) return true;
  return count <= 3;
}

}  // namespace
}  // namespace groundtruth

int main(int count, char** arguments) {
  using namespace groundtruth;
  if (count < 3) return 2;
  const std::uint64_t seed = std::stoull(arguments[1]), asks = std::stoull(arguments[2]);
  std::uint64_t wrong = 0;
  for (const auto& builtin : cases::builtin_scenes()) {
    if (!is_wanted(builtin.name, count, arguments)) continue;
    const auto pack = builtin.build();
    Tally tally;
    for (std::size_t part = 0; part < pack.size(); ++part)
      run_part(pack[part], cases::seed_of_part(seed, part), asks / pack.size() + 1,
               std::string(builtin.name) + ":" + std::to_string(part), tally);
    std::printf("%s: %llu asks, %llu differ\n", std::string(builtin.name).c_str(),
                static_cast<unsigned long long>(tally.asks), static_cast<unsigned long long>(tally.wrong));
    print("place", tally.place);
    print("lambda", tally.lambda);
    print("material", tally.material);
    std::fflush(stdout);
    wrong += tally.wrong;
  }
  return wrong == 0 ? 0 : 1;
}
