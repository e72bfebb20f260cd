#include <groundtruth/validation/log.hpp>

#include <groundtruth/validation/text_file.hpp>

#include "json_lines.hpp"

namespace groundtruth::validation {
namespace {

constexpr std::string_view version = "validation/1";
constexpr std::array kinds{Kind::entry, Kind::clip, Kind::step};

std::string counts_of(const Tally& tally, Kind kind) {
  ObjectWriter writer;
  for (std::size_t i = 0; i < number_of_outcomes; ++i) {
    const auto outcome = static_cast<Outcome>(i);
    writer.count(name_of(outcome), tally.count(kind, outcome));
  }
  return writer.take();
}

Summary summary_in(const std::string& line, const Origin& origin) {
  const ObjectReader reader(line, origin);
  const ObjectReader counts(reader.json("summary"), origin);
  Summary summary;
  for (const Kind kind : kinds) {
    const std::string name(name_of(kind));
    const ObjectReader of_kind(counts.json(name.c_str()), origin);
    for (std::size_t i = 0; i < number_of_outcomes; ++i) {
      const auto outcome = static_cast<Outcome>(i);
      const std::string outcome_name(name_of(outcome));
      summary.tally.add(kind, outcome, of_kind.count(outcome_name.c_str()));
    }
  }
  summary.ending = reader.text("ending");
  summary.seconds = reader.number("seconds");
  return summary;
}

Head head_in(const std::string& line, const Origin& origin) {
  const ObjectReader reader(line, origin);
  if (reader.text("groundtruth") != version) reader.refuse("groundtruth", "is not validation/1");
  Head head{reader.text("subject"),
            reader.count("seed"),
            reader.count("cases"),
            {reader.count("shard"), reader.count("shards")},
            reader.text("tolerance")};
  if (head.shard.index == 0 || head.shard.index > head.shard.count) {
    reader.refuse("shard", "is none of 1 to shards");
  }
  return head;
}

bool is_json(const std::string& line) {
  try {
    const ObjectReader reader(line, {});
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

}  // namespace

std::string write_head(const Head& head) {
  ObjectWriter writer;
  writer.text("groundtruth", version);
  writer.text("subject", head.subject);
  writer.count("seed", head.seed);
  writer.count("cases", head.cases);
  writer.count("shard", head.shard.index);
  writer.count("shards", head.shard.count);
  writer.text("tolerance", head.tolerance);
  return writer.take();
}

std::string write_cause(const Cause& cause) {
  ObjectWriter writer;
  writer.text("cause", cause.group.kind);
  writer.count("cases", cause.group.members.size());
  writer.text("signature", cause.group.signature);
  writer.json("smallest", write_record(record_of(cause.smallest)));
  std::string names;
  for (const std::string& name : cause.group.does_not_matter) names += (names.empty() ? "" : ", ") + name;
  writer.text("does_not_matter", names);
  return writer.take();
}

std::string write_diagnosis(const diagnosis::Diagnosis& diagnosis) {
  ObjectWriter writer;
  writer.text("diagnosis", diagnosis.name);
  writer.text("explanation", diagnosis.explanation);
  writer.count("explains", diagnosis.explained);
  writer.count("of", diagnosis.failures);
  return writer.take();
}

std::string write_summary(const Summary& summary) {
  ObjectWriter counts;
  for (const Kind kind : kinds) counts.json(name_of(kind), counts_of(summary.tally, kind));
  ObjectWriter writer;
  writer.json("summary", counts.take());
  writer.text("ending", summary.ending);
  writer.seconds("seconds", summary.seconds);
  return writer.take();
}

Log read_log(const std::string& file) {
  std::vector<std::string> lines = read_text_lines(file);
  if (lines.size() > 1 && !is_json(lines.back())) lines.pop_back();
  if (lines.empty()) throw BadInput(file, 1, "", "is empty: no output of validate --json");
  Log log{file, head_in(lines.front(), {file, 1}), {}, {}};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Origin origin{file, i + 1};
    const ObjectReader reader(lines[i], origin);
    if (reader.has("summary")) {
      log.summary = summary_in(lines[i], origin);
    } else if (!is_about_the_run(reader)) {
      log.records.push_back(read_record(lines[i], origin));
    }
  }
  return log;
}

}  // namespace groundtruth::validation
