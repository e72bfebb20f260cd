#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <fmt/core.h>

#include <groundtruth/explanation/explanation.hpp>
#include <groundtruth/implementations/subject.hpp>
#include <groundtruth/judge/verdict.hpp>
#include <groundtruth/page/html_page.hpp>
#include <groundtruth/page/text_page.hpp>
#include <groundtruth/text/scene_text.hpp>
#include <groundtruth/validation/replay.hpp>

#include "for_shell.hpp"
#include "subcommand.hpp"
#include "validation_files.hpp"

namespace groundtruth::cli {
namespace {

using explanation::Explanation;
using explanation::Opinion;
using implementations::Reply;
using implementations::ReplyKind;

struct Options {
  std::string asks;
  std::string scene;
  std::string html;
  bool implementation = false;
  std::vector<std::string> command;
};

std::vector<cases::Case> cases_for(const Options& options) {
  std::vector<cases::Case> asked = validation::cases_to_replay(options.asks);
  if (asked.empty()) throw BadInput(options.asks, 1, "", "holds no ask");
  if (options.scene.empty()) return asked;
  const Scene scene = read_scene_file(options.scene);
  for (cases::Case& one : asked) one.scene = scene;
  return asked;
}

std::string replay_command_of(const Options& options) {
  std::string command = "groundtruth explain " + for_shell(options.asks);
  if (!options.scene.empty()) command += " --scene " + for_shell(options.scene);
  if (options.command.empty()) return command;
  command += " --implementation --";
  for (const std::string& word : options.command) command += " " + for_shell(word);
  return command;
}

page::Colours colours() {
  const char* no_color = std::getenv("NO_COLOR");
  const bool unwanted = no_color != nullptr && *no_color != '\0';
  return !unwanted && isatty(STDOUT_FILENO) != 0 ? page::Colours::ansi : page::Colours::none;
}

std::unique_ptr<implementations::Subject> subject_of(const Options& options) {
  if (options.command.empty()) return nullptr;
  auto subject = implementations::run_command(options.command, {});
  if (const auto* none = std::get_if<implementations::NoSubject>(&subject))
    throw std::runtime_error("--implementation: " + none->problem);
  return std::get<std::unique_ptr<implementations::Subject>>(std::move(subject));
}

std::string difference_in(const Reply& reply, const cases::Case& asked) {
  if (reply.kind != ReplyKind::answered && reply.kind != ReplyKind::refused) return reply.detail;
  const Answer got =
      reply.kind == ReplyKind::refused ? Answer(StepAnswer{Refusal{reply.detail}}) : reply.answer;
  const judge::Verdict verdict = judge::Judge(asked.scene, {}).judge(asked.ask, got);
  if (verdict.is_accepted()) return "";
  return fmt::format("differs in {}: {}", judge::name_of(verdict.difference), verdict.explanation);
}

Explanation explanation_of(const cases::Case& asked, implementations::Subject* subject) {
  Explanation explanation = explanation::explain(asked);
  if (subject == nullptr) return explanation;
  const Reply reply = subject->ask(asked.scene, std::array{asked.ask}).front();
  const std::string& name = subject->greeting().name;
  const Opinion theirs{"yours" + (name.empty() ? name : ": " + name), reply.text,
                       difference_in(reply, asked)};
  explanation.opinions.insert(explanation.opinions.begin(), theirs);
  return explanation;
}

// Of a file without its folders; of a case of the corpus all of it.
std::string short_name_of(const std::string& asks) {
  return std::filesystem::exists(asks) ? std::filesystem::path(asks).filename().string() : asks;
}

// A case of a file goes by the file's name, and by what it is called there.
std::string heading_of(const cases::Case& asked) {
  if (!asked.flags.empty()) return asked.id;
  return std::filesystem::path(asked.id).filename().string() + (asked.note.empty() ? "" : ", " + asked.note);
}

Exit run(const Options& options) {
  if (options.implementation != !options.command.empty()) {
    fmt::print(stderr, "groundtruth explain: give an implementation as --implementation -- COMMAND\n");
    return Exit::usage;
  }
  const std::unique_ptr<implementations::Subject> subject = subject_of(options);
  const std::string replay = replay_command_of(options);
  std::vector<page::Section> sections;
  for (const cases::Case& asked : cases_for(options)) {
    sections.push_back({explanation_of(asked, subject.get()), replay, heading_of(asked), {}});
    if (options.html.empty())
      fmt::print("{}\n", page::text_page(sections.back().explanation, replay, colours()));
  }
  if (!options.html.empty())
    write_text(options.html,
               page::html_page(sections, "Groundtruth explains " + short_name_of(options.asks)));
  return Exit::agrees;
}

}  // namespace

Subcommand add_explain(CLI::App& program) {
  CLI::App* command = program.add_subcommand("explain", "Tells everything about an ask, on one page");
  const auto options = std::make_shared<Options>();
  command->add_option("asks", options->asks, "A file of asks, or the id of a case")->required();
  command->add_option("--scene", options->scene, "The scene of all the asks, instead of the file's own");
  command->add_option("--html", options->html, "Write a page to look at to this file, and none of text");
  command->add_flag("--implementation", options->implementation,
                    "Show what the program after -- answers, too");
  command->add_option("command", options->command, "The implementation, and its arguments");
  return {command, [options] { return run(*options); }};
}

}  // namespace groundtruth::cli
