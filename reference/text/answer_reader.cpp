#include <algorithm>

#include <groundtruth/text/answer_text.hpp>
#include <groundtruth/text/field.hpp>
#include <groundtruth/text/shared_readers.hpp>

namespace groundtruth {
namespace {

std::size_t read_count(const Field& field) {
  const double value = field.number();
  constexpr double largest = 9007199254740992;  // 2^53
  if (!(value >= 0 && value <= largest) || value != static_cast<double>(static_cast<std::size_t>(value))) {
    field.refuse_value("is not a leaf's number");
  }
  return static_cast<std::size_t>(value);
}

std::optional<MaterialIndex> read_material(const Field& field, const Scene& scene) {
  if (field.is_null()) return std::nullopt;
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const Material& material) { return material.name == field.text(); });
  if (found == scene.materials.end()) field.refuse_value("is not a material of the scene");
  return static_cast<MaterialIndex>(found - scene.materials.begin());
}

EntryAnswer read_entry(const Field& field, const Scene& scene) {
  const Field kind = field["kind"];
  if (kind.text() == "miss") return Miss{};
  if (kind.text() == "inside") return Inside{field["lambda"].number()};
  if (kind.text() != "border") kind.refuse_value("is neither miss nor inside nor border");
  return Border{field["lambda"].number(), read_count(field["leaf"]), field["normal"].vector(),
                read_material(field["material"], scene)};
}

ClipAnswer read_clip(const Field& field) {
  const Field kind = field["kind"];
  if (kind.text() == "too_steep") return TooSteep{};
  if (kind.text() == "stick") return Clipped{Grip::stick, field["force"].vector()};
  if (kind.text() == "slip") return Clipped{Grip::slip, field["force"].vector()};
  kind.refuse_value("is neither stick nor slip nor too_steep");
}

StepAnswer read_step(const Field& field) {
  const Field outcome = field["outcome"];
  if (outcome.text() == "ok") return Stepped{read_state(field["state"]), field["force"].vector()};
  if (outcome.text() == "wheel_broken") return StepFailure::wheel_broken;
  if (outcome.text() == "surface_too_steep") return StepFailure::surface_too_steep;
  if (outcome.text() == "surface_gave_way") return StepFailure::surface_gave_way;
  outcome.refuse_value("is no outcome");
}

Evidence read_evidence(const Field& field) {
  Evidence evidence;
  if (const auto lambda = field.find("lambda_exact")) evidence.lambda_exact = lambda->text();
  if (const auto admissible = field.find("admissible")) {
    for (std::size_t i = 0; i < admissible->size(); ++i)
      evidence.admissible.push_back(read_count((*admissible)[i]));
  }
  return evidence;
}

struct ReadAnswer {
  const Field& field;
  const Scene& scene;
  Answer operator()(const EntryAsk&) const { return read_entry(field, scene); }
  Answer operator()(const ClipAsk&) const { return read_clip(field); }
  Answer operator()(const StepAsk&) const { return read_step(field); }
};

}  // namespace

HelloAnswer read_hello(std::string_view text, const Origin& origin) {
  const Json json = parse_json(text, origin);
  const Field line(json, origin);
  line.object();
  HelloAnswer hello{line["hello"].text(), {}, {}};
  if (const auto name = line.find("name"); name && name->is_text()) hello.name = name->text();
  const auto asks = line.find("asks");
  if (!asks || !std::holds_alternative<Json::Array>(asks->json().value)) return hello;
  hello.asks.emplace();
  for (std::size_t i = 0; i < asks->size(); ++i) {
    if ((*asks)[i].is_text()) hello.asks->push_back((*asks)[i].text());
  }
  return hello;
}

std::string read_id(std::string_view text) {
  try {
    return id_of(parse_json(text, {}));
  } catch (const BadInput&) {
    return "null";
  }
}

AnswerLine read_answer(std::string_view text, const Ask& ask, const Scene& scene, const Origin& origin) {
  const Json json = parse_json(text, origin);
  const Field line(json, origin);
  line.object();
  AnswerLine read;
  read.id = id_of(json);
  if (const auto error = line.find("error")) {
    read.answer = Refusal{error->text()};
    return read;
  }
  const Field answer = line["answer"];
  answer.object();
  read.answer = std::visit(ReadAnswer{answer, scene}, ask);
  read.evidence = read_evidence(answer);
  return read;
}

std::string read_answer_id(std::string_view text) {
  try {
    return id_of(parse_json(text, {}));
  } catch (const BadInput&) {
    return "null";
  }
}

}  // namespace groundtruth
