#include <groundtruth/report/scene_report.hpp>

#include <fmt/format.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

namespace groundtruth::report {

std::string table_of(const CompiledScene& scene) {
  const implementations::Compilation& made = scene.compilation;
  std::string text =
      fmt::format("{}: {} half-spaces; {} convex parts, {} others; compiled in {:.3g} ms\n", scene.name,
                  made.half_spaces, made.convex_parts, made.general_parts, 1e3 * made.seconds);
  for (const implementations::LeftOut& one : made.left_out)
    text += fmt::format("  {:<24}{:>8}  {}\n", one.what, one.count, one.why);
  return text;
}

std::string json_of(const CompiledScene& scene) {
  const implementations::Compilation& made = scene.compilation;
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  writer.StartObject();
  writer.Key("scene");
  writer.String(scene.name.c_str());
  writer.Key("half_spaces");
  writer.Uint64(made.half_spaces);
  writer.Key("convex_parts");
  writer.Uint64(made.convex_parts);
  writer.Key("general_parts");
  writer.Uint64(made.general_parts);
  writer.Key("seconds");
  writer.Double(made.seconds);
  writer.Key("left_out");
  writer.StartArray();
  for (const implementations::LeftOut& one : made.left_out) {
    writer.StartObject();
    writer.Key("what");
    writer.String(one.what.c_str());
    writer.Key("count");
    writer.Uint64(one.count);
    writer.Key("why");
    writer.String(one.why.c_str());
    writer.EndObject();
  }
  writer.EndArray();
  writer.EndObject();
  return std::string(buffer.GetString()) + "\n";
}

}  // namespace groundtruth::report
