#include <groundtruth/report/vector_files.hpp>

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <groundtruth/implementations/engine.hpp>
#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>

#include "vector_schema.hpp"

namespace groundtruth::report {
namespace {

constexpr const char* readme = R"(Vectors of Groundtruth: ground contact, asked and answered exactly

asks.jsonl     a line a scene or an ask; a scene holds for the asks that follow
answers.jsonl  a line an ask, in the same order, by the exact engine: doubles are the nearest to the exact values,
               "lambda_exact" is the exact fraction, "admissible" lists every leaf that may be named
cases.json     for each ask its id, flags, and why it exists
schema.json    JSON Schema of a line of asks.jsonl (#/$defs/ask_line) and of answers.jsonl (#/$defs/answer_line)

Answer asks.jsonl with your implementation, a line an ask, and judge what it said:

    groundtruth judge asks.jsonl YOURS.jsonl --profile double

Or compare by hand: the kind must be the same; lambda within an ulp of "lambda_exact"; the leaf one of
"admissible", its normal a positive multiple of that leaf's. Ids are stable: cases are added, never changed.
)";

using Writer = rapidjson::PrettyWriter<rapidjson::StringBuffer>;

void write(Writer& writer, const std::string& text) {
  writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}

std::string quoted(const std::string& id) { return "\"" + id + "\""; }

std::string catalogue(const std::vector<cases::Case>& cases) {
  rapidjson::StringBuffer buffer;
  Writer writer(buffer);
  writer.SetFormatOptions(rapidjson::kFormatSingleLineArray);
  writer.StartArray();
  for (const cases::Case& one : cases) {
    writer.StartObject();
    writer.Key("id");
    write(writer, one.id);
    writer.Key("flags");
    writer.StartArray();
    for (const std::string& flag : one.flags) write(writer, flag);
    writer.EndArray();
    writer.Key("note");
    write(writer, one.note);
    writer.EndObject();
  }
  writer.EndArray();
  return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

}  // namespace

std::vector<VectorFile> vector_files(const std::vector<cases::Case>& cases) {
  const auto engine = implementations::make_engine("exact");
  std::string asks;
  std::string answers;
  std::string scene_line;
  for (const cases::Case& one : cases) {
    const std::string line = write_scene_line(one.scene);
    if (line != scene_line) asks += line + "\n";
    scene_line = line;
    asks += write_ask(quoted(one.id), one.ask) + "\n";
    const auto answered = engine->on(one.scene)->answer(one.ask);
    answers += write_answer(quoted(one.id), answered.answer, answered.evidence, one.scene) + "\n";
  }
  return {{"asks.jsonl", asks},
          {"answers.jsonl", answers},
          {"cases.json", catalogue(cases)},
          {"schema.json", vector_schema},
          {"README.txt", readme}};
}

}  // namespace groundtruth::report
