#include <groundtruth/report/judge_report.hpp>

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

namespace groundtruth::report {
namespace {

constexpr const char* kinds[] = {"entry", "clip", "step", "bad"};

std::string what_is_wrong(const JudgedAsk& asked) {
  if (asked.judged != Judged::wrong) return std::string(name_of(asked.judged));
  return fmt::format("wrong {}", judge::name_of(asked.verdict.difference));
}

}  // namespace

std::string_view name_of(Judged judged) {
  constexpr std::array<std::string_view, number_of_judged> names = {"accepted", "wrong", "skipped",
                                                                    "unreadable"};
  return names[static_cast<std::size_t>(judged)];
}

std::string line_of(const JudgedAsk& asked) {
  return fmt::format("{} {}: {}: {}\n", asked.place, asked.id, what_is_wrong(asked), asked.explanation);
}

std::string json_of(const JudgedAsk& asked) {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  const auto text = [&](const char* key, std::string_view value) {
    writer.Key(key);
    writer.String(value.data(), static_cast<rapidjson::SizeType>(value.size()));
  };
  const auto number = [&](const char* key, double value) {
    writer.Key(key);
    writer.Double(value);
  };
  writer.StartObject();
  writer.Key("id");
  writer.RawValue(asked.id.data(), asked.id.size(), rapidjson::kStringType);
  text("ask", asked.kind);
  text("place", asked.place);
  text("verdict", name_of(asked.judged));
  if (asked.judged == Judged::wrong) {
    text("difference", judge::name_of(asked.verdict.difference));
    number("lambda_ulps", asked.verdict.lambda_ulps);
    number("metres", asked.verdict.metres);
    number("newtons", asked.verdict.newtons);
  }
  if (!asked.explanation.empty()) text("explanation", asked.explanation);
  if (!asked.exact.empty()) {
    writer.Key("exact");
    writer.RawValue(asked.exact.data(), asked.exact.size(), rapidjson::kObjectType);
  }
  writer.EndObject();
  return std::string(buffer.GetString(), buffer.GetSize()) + "\n";
}

std::string json_summary_of(const std::vector<JudgedAsk>& asked, std::size_t left_over) {
  std::array<std::size_t, number_of_judged> counts{};
  for (const JudgedAsk& one : asked) ++counts[static_cast<std::size_t>(one.judged)];
  std::string text = "{\"summary\":{";
  for (std::size_t i = 0; i < number_of_judged; ++i)
    text += fmt::format("\"{}\":{},", name_of(static_cast<Judged>(i)), counts[i]);
  return text + fmt::format("\"left_over\":{}}}}}\n", left_over);
}

std::string table_of(const std::vector<JudgedAsk>& asked) {
  std::string text = fmt::format("{:<8}", "ask");
  for (std::size_t i = 0; i < number_of_judged; ++i)
    text += fmt::format("{:>12}", name_of(static_cast<Judged>(i)));
  text += "\n";
  for (const char* kind : kinds) {
    std::array<std::size_t, number_of_judged> counts{};
    for (const JudgedAsk& one : asked) {
      if (one.kind == kind) ++counts[static_cast<std::size_t>(one.judged)];
    }
    if (std::all_of(counts.begin(), counts.end(), [](std::size_t count) { return count == 0; })) continue;
    text += fmt::format("{:<8}", kind);
    for (const std::size_t count : counts) text += fmt::format("{:>12}", count);
    text += "\n";
  }
  std::map<std::string_view, std::size_t> differences;
  for (const JudgedAsk& one : asked) {
    if (one.judged == Judged::wrong) ++differences[judge::name_of(one.verdict.difference)];
  }
  for (const auto& [difference, count] : differences)
    text += fmt::format("wrong {}: {}\n", difference, count);
  return text;
}

}  // namespace groundtruth::report
