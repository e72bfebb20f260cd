#include <chrono>
#include <memory>
#include <optional>
#include <regex>
#include <thread>

#include <fmt/core.h>

#include <groundtruth/campaign/campaign.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/report/check_report.hpp>
#include <groundtruth/text/ask_text.hpp>

#include "named_pack.hpp"
#include "progress_bar.hpp"
#include "subcommand.hpp"

namespace groundtruth::cli {
namespace {

struct Options {
  std::uint64_t seed = 1;
  std::uint64_t cases = 100000;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::string> scenes;  // files or built-in names; none: all built-in ones
  std::string witness;              // empty: none but those of this program
  std::string show;
  bool json = false;
};

// SCENE:PART:INDEX, as the report writes it; a file's name may have colons in it.
struct AskName {
  std::string scene;
  std::size_t part = 0;
  std::uint64_t index = 0;
};

std::optional<AskName> read_ask_name(const std::string& text) {
  static const std::regex form("(.+):([0-9]{1,9}):([0-9]{1,18})");
  std::smatch match;
  if (!std::regex_match(text, match, form)) return std::nullopt;
  return AskName{match[1], std::stoul(match[2]), std::stoull(match[3])};
}

Exit refuse_show(const std::string& problem) {
  fmt::print(stderr, "groundtruth check: --show: {}\n", problem);
  return Exit::usage;
}

Exit show(const Options& options) {
  const auto name = read_ask_name(options.show);
  if (!name) return refuse_show(options.show + " is not SCENE:PART:INDEX");
  const NamedPack named = pack_named(name->scene);
  if (name->part >= named.pack.size()) {
    return refuse_show(fmt::format("{} has {} parts, numbered from 0", name->scene, named.pack.size()));
  }
  const auto source = campaign::asks_for({named.pack, {}, options.seed, 0, 1}, name->part);
  fmt::print("{}\n{}\n", write_scene_line(named.pack[name->part]),
             write_ask("\"" + options.show + "\"", source.ask_at(name->index).ask));
  return Exit::agrees;
}

report::CheckedScene check(const NamedPack& named, const Options& options, std::uint64_t cases,
                           ProgressBar& bar) {
  report::CheckedScene checked{named.name, 0, implementations::engine_names(), {}};
  if (!options.witness.empty()) checked.engines.push_back(options.witness);
  for (const Scene& scene : named.pack) checked.leaves += cases::leaf_count(scene.shape);
  const campaign::Plan plan{named.pack, checked.engines, options.seed, cases, options.jobs};
  checked.tallies = campaign::run(plan, [&](std::uint64_t done) { bar.show(named.name, done, cases); });
  return checked;
}

// Of the witnesses and of the fast engine: they claim to say what `exact` says. The others do not.
std::uint64_t broken_claims(const report::CheckedScene& checked, const Options& options) {
  std::uint64_t broken = 0;
  for (std::size_t i = 0; i < checked.engines.size(); ++i) {
    const std::string& engine = checked.engines[i];
    const bool claims = engine == "definition" || engine == "fast" || engine == options.witness;
    if (claims) broken += checked.tallies[i].disagreements();
  }
  return broken;
}

// Of all scenes, by the witness that was asked for.
struct Witnessed {
  std::uint64_t asks = 0;
  std::uint64_t left_out = 0;

  void add(const report::CheckedScene& checked, const std::string& witness) {
    for (std::size_t i = 0; i < checked.engines.size(); ++i) {
      if (checked.engines[i] != witness) continue;
      asks += checked.tallies[i].asks();
      left_out += checked.tallies[i].left_out();
    }
  }
};

void print(const report::CheckedScene& checked, const Options& options) {
  if (options.json) {
    fmt::print("{}", report::json_of(checked));
    return;
  }
  fmt::print("{}", report::table_of(checked));
  const std::string show_command = fmt::format("groundtruth check --seed {} --show", options.seed);
  for (std::size_t i = 1; i < checked.engines.size(); ++i) {
    if (checked.engines[i] != "as-written") fmt::print("{}", report::findings_of(checked, i, show_command));
  }
  fmt::print("\n");
}

Exit run(const Options& options) {
  if (!options.show.empty()) return show(options);
  if (!options.witness.empty() && implementations::make_engine(options.witness) == nullptr) {
    fmt::print(
        stderr,
        "groundtruth check: --witness {}: proved-phi, which is built where Coq and OCaml are installed "
        "(.ci/install-dependencies --with-proofs), is neither beside this program nor on PATH\n",
        options.witness);
    return Exit::usage;
  }
  const auto start = std::chrono::steady_clock::now();
  const std::vector<NamedPack> packs = packs_named(options.scenes);
  if (!options.json) fmt::print("seed {}, {} asks, {} jobs\n\n", options.seed, options.cases, options.jobs);
  std::uint64_t wrong = 0;
  Witnessed witnessed;
  ProgressBar bar;
  for (std::size_t i = 0; i < packs.size(); ++i) {
    const std::uint64_t cases = options.cases / packs.size() + (i < options.cases % packs.size() ? 1 : 0);
    const report::CheckedScene checked = check(packs[i], options, cases, bar);
    bar.clear();
    print(checked, options);
    std::fflush(stdout);
    wrong += broken_claims(checked, options);
    witnessed.add(checked, options.witness);
  }
  if (!options.json) {
    if (!options.witness.empty()) {
      fmt::print("{} answered {} asks; {} were not put to it, on large scenes where it is slow\n",
                 options.witness, witnessed.asks, witnessed.left_out);
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    fmt::print("exact, definition{} {}; {:.1f} s\n",
               options.witness.empty() ? " and fast" : ", fast and proved",
               wrong == 0 ? "agree" : fmt::format("DISAGREE on {} answers", wrong), seconds.count());
  }
  return wrong == 0 ? Exit::agrees : Exit::disagrees;
}

}  // namespace

Subcommand add_check(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("check", "Puts the same asks to every engine and counts where they differ");
  const auto options = std::make_shared<Options>();
  command->add_option("--seed", options->seed, "Of the asks")->capture_default_str();
  command->add_option("--cases", options->cases, "How many asks, shared out over the scenes")
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "Threads")
      ->check(CLI::Range(1U, 1024U))
      ->capture_default_str();
  command->add_option("--scene", options->scenes,
                      "A scene file or the name of a built-in scene; may be repeated");
  command
      ->add_option("--witness", options->witness,
                   "Ask this one too: proved (entry asks only, fewer on large scenes: it is slow)")
      ->check(CLI::IsMember({"proved"}));
  command->add_option("--show", options->show,
                      "Print the scene and the ask SCENE:PART:INDEX, for groundtruth answer");
  command->add_flag("--json", options->json, "One JSON object a scene and engine");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
