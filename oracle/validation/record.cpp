#include <groundtruth/validation/record.hpp>

#include <array>
#include <optional>

#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>

#include "json_lines.hpp"

namespace groundtruth::validation {
namespace {

constexpr std::array<std::string_view, 5> expectations{"none", "known", "changed", "unexpected", "passes"};

Expectation expectation_named(const ObjectReader& reader) {
  if (!reader.has("expectation")) return Expectation::none;
  const std::string name = reader.text("expectation");
  for (std::size_t i = 0; i < expectations.size(); ++i) {
    if (expectations[i] == name) return static_cast<Expectation>(i);
  }
  reader.refuse("expectation", name + " is none");
}

bool is_json_object(std::string_view text) {
  try {
    const ObjectReader reader(text, {});
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

// An engine in this process gives answers, not lines.
std::string got_of(const Failure& failure, const std::string& id) {
  const implementations::Reply& reply = failure.finding.reply;
  if (!reply.text.empty()) return is_json_object(reply.text) ? reply.text : quoted(reply.text);
  if (reply.kind == implementations::ReplyKind::answered) {
    return write_answer(id, reply.answer, reply.evidence, failure.asked.scene);
  }
  if (reply.kind == implementations::ReplyKind::refused) return write_error(id, reply.detail);
  return "null";
}

// The outcomes that a list of failures may hold.
Outcome failing_outcome_in(const ObjectReader& reader) {
  const std::string name = reader.text("verdict");
  const std::optional<Outcome> outcome = outcome_named(name);
  if (!outcome || *outcome == Outcome::skipped) reader.refuse("verdict", name + " is none");
  return *outcome;
}

}  // namespace

std::string_view name_of(Expectation expectation) {
  return expectations[static_cast<std::size_t>(expectation)];
}

Record record_of(const Failure& failure) {
  const std::string id = quoted(failure.asked.id);
  const Finding& finding = failure.finding;
  Record record;
  record.id = failure.asked.id;
  record.ask_number = finding.ask_number;
  record.kind = kind_of_ask(failure.asked.ask);
  record.outcome = finding.outcome;
  const bool is_wrong = finding.outcome == Outcome::wrong;
  record.difference = judge::name_of(is_wrong ? finding.verdict.difference : judge::Difference::none);
  record.scene = write_scene(failure.asked.scene);
  record.ask = write_ask(id, failure.asked.ask);
  record.got = got_of(failure, id);
  record.exact = write_answer(id, finding.verdict.exact, finding.verdict.evidence, failure.asked.scene);
  record.explanation = explanation_of(finding);
  record.seconds = finding.seconds;
  return record;
}

std::string write_record(const Record& record) {
  ObjectWriter writer;
  writer.text("case", record.id);
  writer.count("ask_number", record.ask_number);
  writer.text("kind", name_of(record.kind));
  writer.text("verdict", name_of(record.outcome));
  writer.text("difference", record.difference);
  if (record.expectation != Expectation::none) writer.text("expectation", name_of(record.expectation));
  writer.json("scene", record.scene);
  writer.json("ask", record.ask);
  writer.json("got", record.got);
  writer.json("exact", record.exact);
  writer.text("explanation", record.explanation);
  writer.seconds("seconds", record.seconds);
  return writer.take();
}

Record read_record(std::string_view text, const Origin& origin) {
  const ObjectReader reader(text, origin);
  Record record;
  record.id = reader.text("case");
  record.ask_number = reader.count("ask_number");
  const std::optional<Kind> kind = kind_named(reader.text("kind"));
  if (!kind) reader.refuse("kind", reader.text("kind") + " is none of entry, clip, step");
  record.kind = *kind;
  record.outcome = failing_outcome_in(reader);
  record.difference = reader.text("difference");
  record.expectation = expectation_named(reader);
  record.scene = reader.json("scene");
  record.ask = reader.json("ask");
  record.got = reader.json("got");
  record.exact = reader.json("exact");
  record.explanation = reader.text("explanation");
  record.seconds = reader.number("seconds");
  return record;
}

cases::Case case_of(const Record& record, const Origin& origin) {
  const Line line = read_line(record.ask, origin);
  const auto* ask = std::get_if<AskLine>(&line);
  if (ask == nullptr) throw BadInput(origin.place, origin.first_line, "ask", "is none");
  return {record.id, read_scene(record.scene, origin), ask->ask, {}, {}};
}

}  // namespace groundtruth::validation
