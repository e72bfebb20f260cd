#include <memory>

#include <fmt/core.h>

#include <groundtruth/report/scene_report.hpp>

#include "named_pack.hpp"
#include "subcommand.hpp"

namespace groundtruth::cli {
namespace {

enum class Form { table, json };

struct Options {
  std::vector<std::string> scenes;  // files or built-in names; none: all built-in ones
  Form form = Form::table;
};

Exit run(const Options& options) {
  for (const NamedPack& named : packs_named(options.scenes)) {
    std::size_t part = 0;
    for (const Scene& scene : named.pack) {
      const std::string name = named.pack.size() == 1 ? named.name : fmt::format("{}:{}", named.name, part++);
      const report::CompiledScene compiled{name, implementations::compilation_of(scene)};
      fmt::print("{}", options.form == Form::json ? report::json_of(compiled) : report::table_of(compiled));
    }
  }
  return Exit::agrees;
}

}  // namespace

Subcommand add_scene(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("scene", "Tells what fast makes of a scene: what it leaves out, and why");
  const auto options = std::make_shared<Options>();
  command->add_option("scenes", options->scenes,
                      "Scene files or names of built-in scenes; none: all of these");
  command->add_flag_callback(
      "--json", [options] { options->form = Form::json; }, "One JSON object a scene");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
