#include <groundtruth/validation/replay.hpp>

#include <filesystem>
#include <optional>

#include <groundtruth/cases/corpus.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>
#include <groundtruth/validation/case_name.hpp>
#include <groundtruth/validation/making.hpp>
#include <groundtruth/validation/record.hpp>
#include <groundtruth/validation/text_file.hpp>

#include "json_lines.hpp"

namespace groundtruth::validation {
namespace {

class AskFile {
 public:
  explicit AskFile(const std::string& file) : file_(file) {}

  std::optional<cases::Case> read(const std::string& text, const Origin& origin) {
    const Line line = read_line(text, origin);
    if (const auto* bad = std::get_if<BadLine>(&line)) throw std::runtime_error(bad->problem);
    if (const auto* bad = std::get_if<BadSceneLine>(&line)) throw std::runtime_error(bad->problem);
    if (const auto* scene = std::get_if<SceneLine>(&line)) scene_ = scene->scene;
    if (const auto* scene = std::get_if<SceneFileLine>(&line)) {
      scene_ = read_scene_file((std::filesystem::path(file_).parent_path() / scene->file).string());
    }
    const auto* ask = std::get_if<AskLine>(&line);
    if (ask == nullptr) return std::nullopt;
    const std::string id = file_ + ":" + std::to_string(origin.first_line);
    return cases::Case{id, scene_, ask->ask, {}, "id " + ask->id};
  }

 private:
  std::string file_;
  Scene scene_{{}, {Nothing{}}};
};

std::vector<cases::Case> cases_in(const std::string& file) {
  const std::vector<std::string> lines = read_text_lines(file);
  std::vector<cases::Case> found;
  AskFile asks(file);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Origin origin{file, i + 1};
    const ObjectReader reader(lines[i], origin);
    if (reader.has("case")) {
      found.push_back(case_of(read_record(lines[i], origin), origin));
    } else if (!is_about_the_run(reader)) {
      if (auto asked = asks.read(lines[i], origin)) found.push_back(std::move(*asked));
    }
  }
  return found;
}

}  // namespace

std::vector<cases::Case> cases_to_replay(const std::string& what) {
  for (const cases::Case& one : cases::corpus()) {
    if (one.id == what) return {one};
  }
  if (const auto name = read_case_name(what)) return {make_case(*name)};
  if (std::filesystem::exists(what)) return cases_in(what);
  throw BadInput(what, 1, "", "is no case of the corpus, no SEED:STRAND:BATCH:KINDNUMBER, and no file");
}

}  // namespace groundtruth::validation
