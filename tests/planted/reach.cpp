// planted_reach [SEED [ASKS [NAME...]]]: how many of the generated asks about the built-in scenes show each
// planted mistake, and by which flavours; with a witness, as small as was seen, in lines of JSON on the error
// stream.

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <map>
#include <set>
#include <string>

#include <fmt/core.h>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/judge/verdict.hpp>
#include <groundtruth/text/ask_text.hpp>

#include "planted_engine.hpp"

namespace groundtruth::planted {
namespace {

struct Witness {
  std::size_t leaves = 0;
  std::string lines;
};

struct Reached {
  std::size_t asks = 0;
  std::map<std::string_view, std::size_t> by_flavour;
  Witness witness;
};

// The asks about one scene of those built in.
class Part {
 public:
  Part(const Scene& scene, std::uint64_t seed, std::size_t count) : scene_(scene), judge_(scene, {}) {
    cases::AskSource source(scene, seed);
    for (std::size_t i = 0; i < count; ++i) asked_.push_back(source.next());
  }

  void show(const Bug& bug, Reached& reached) const {
    const Answering planted = bug.on(scene_);
    for (const cases::GeneratedAsk& generated : asked_) {
      if (static_cast<Kind>(generated.ask.index()) != bug.kind) continue;
      if (judge_.judge(generated.ask, planted(generated.ask)).is_accepted()) continue;
      ++reached.asks;
      ++reached.by_flavour[cases::name(generated.flavour)];
      const std::size_t leaves = cases::leaf_count(scene_.shape);
      if (reached.witness.lines.empty() || leaves < reached.witness.leaves) {
        reached.witness = {leaves, write_scene_line(scene_) + "\n" +
                                       write_ask(fmt::format("\"{}\"", bug.name), generated.ask)};
      }
    }
  }

 private:
  Scene scene_;
  judge::Judge judge_;
  std::vector<cases::GeneratedAsk> asked_;
};

std::string flavours(const Reached& reached) {
  std::multimap<std::size_t, std::string_view, std::greater<>> ordered;
  for (const auto& [flavour, count] : reached.by_flavour) ordered.emplace(count, flavour);
  std::string text;
  for (const auto& [count, flavour] : ordered) {
    if (text.size() < 60) text += fmt::format(" {} {}", flavour, count);
  }
  return text;
}

void measure(std::uint64_t seed, std::size_t asks, const std::set<std::string_view>& names) {
  std::deque<Part> parts;  // a Part stays where it is: its leaves point into its scene
  const std::size_t scenes = cases::builtin_scenes().size();
  for (const cases::BuiltinScene& builtin : cases::builtin_scenes()) {
    const std::vector<Scene> pack = builtin.build();
    for (std::size_t i = 0; i < pack.size(); ++i) {
      parts.emplace_back(pack[i], cases::seed_of_part(seed, i),
                         std::max<std::size_t>(1, asks / scenes / pack.size()));
    }
  }
  for (const Bug& bug : all_bugs()) {
    if (!names.empty() && !names.contains(bug.name)) continue;
    Reached reached;
    for (const Part& part : parts) part.show(bug, reached);
    fmt::print("{:32} {:5} {:8} {:6} {}\n", bug.name, name(bug.kind), name(bug.reach), reached.asks,
               flavours(reached));
    std::fflush(stdout);
    if (!reached.witness.lines.empty()) fmt::print(stderr, "{}\n", reached.witness.lines);
  }
}

}  // namespace
}  // namespace groundtruth::planted

int main(int count, char** arguments) {
  const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
  const std::size_t asks = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 20000;
  groundtruth::planted::measure(seed, asks, {arguments + std::min(count, 3), arguments + count});
  return 0;
}
