#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/field.hpp>
#include <groundtruth/text/json_writer.hpp>
#include <groundtruth/text/scene_reader.hpp>
#include <groundtruth/text/shared_readers.hpp>
#include <groundtruth/text/wheel_text.hpp>

namespace groundtruth {
namespace {

bool has_key(const Json& line, std::string_view key) {
  const auto* object = std::get_if<Json::Object>(&line.value);
  if (object == nullptr) return false;
  for (const auto& member : *object) {
    if (member.first == key) return true;
  }
  return false;
}

EntryAsk read_entry(const Field& field) {
  field.only({"id", "ask", "from", "to", "range"});
  EntryAsk ask{field["from"].vector(), field["to"].vector()};
  if (const auto range = field.find("range")) {
    range->require_size(2);
    ask.lambda_first = (*range)[0].number();
    ask.lambda_last = (*range)[1].number();
    if (ask.lambda_first > ask.lambda_last) {
      range->refuse("[" + write_decimal(ask.lambda_first) + ", " + write_decimal(ask.lambda_last) +
                    "]: the first is larger than the second");
    }
  }
  return ask;
}

ClipAsk read_clip(const Field& field) {
  field.only({"id", "ask", "force", "normal", "friction", "brake", "min_uprightness"});
  ClipAsk ask{field["force"].vector(), field["normal"].vector(), field["friction"].at_least_zero(),
              field["brake"].at_least_zero()};
  if (const auto uprightness = field.find("min_uprightness")) ask.min_uprightness = uprightness->positive();
  return ask;
}

Frame read_frame(const Field& field) {
  field.only({"position", "orientation", "velocity", "angular_velocity"});
  Frame frame;
  frame.position_in_world = field["position"].vector();
  frame.world_from_wheel = read_orientation(field["orientation"]);
  frame.velocity_in_world = field["velocity"].vector();
  if (const auto angular = field.find("angular_velocity"))
    frame.angular_velocity_in_world = angular->vector();
  return frame;
}

StepAsk read_step(const Field& field) {
  field.only({"id", "ask", "wheel", "frame", "brake", "h", "state"});
  return {read_wheel(field["wheel"]), read_frame(field["frame"]), field["brake"].at_least_zero(),
          field["h"].positive(), read_state(field["state"])};
}

Ask read_ask(const Field& field) {
  const Field kind = field["ask"];
  if (kind.text() == "entry") return read_entry(field);
  if (kind.text() == "clip") return read_clip(field);
  if (kind.text() == "step") return read_step(field);
  kind.refuse_value("is no ask");
}

Line read_scene_line(const Field& field) {
  try {
    field.only({"scene"});
    const Field scene = field["scene"];
    if (scene.is_text()) return SceneFileLine{scene.text()};
    return SceneLine{read_scene(scene)};
  } catch (const BadInput& bad) {
    return BadSceneLine{bad.what()};
  }
}

HelloLine read_hello(const Field& field) {
  field.only({"hello"});
  if (field["hello"].text() != "answers/1") field["hello"].refuse_value("is not \"answers/1\"");
  return {};
}

}  // namespace

std::string id_of(const Json& line) {
  JsonWriter writer;
  const auto* object = std::get_if<Json::Object>(&line.value);
  const Json* id = nullptr;
  for (std::size_t i = 0; object != nullptr && id == nullptr && i < object->size(); ++i) {
    if ((*object)[i].first == "id") id = &(*object)[i].second;
  }
  if (id != nullptr && std::holds_alternative<std::string>(id->value)) {
    writer.text(std::get<std::string>(id->value));
  } else if (id != nullptr && std::holds_alternative<double>(id->value)) {
    writer.number(std::get<double>(id->value));
  } else {
    writer.null();
  }
  return writer.take();
}

WheelState read_state(const Field& field) {
  field.object();
  const Field kind = field["kind"];
  if (kind.text() == "free") {
    field.only({"kind"});
    return Free{};
  }
  if (kind.text() != "stick" && kind.text() != "slip")
    kind.refuse_value("is neither free nor stick nor slip");
  field.only({"kind", "pebble", "velocity", "normal", "static", "dynamic", "max_force"});
  Contact contact{kind.text() == "stick" ? Grip::stick : Grip::slip,
                  field["pebble"].vector(),
                  field["velocity"].vector(),
                  field["normal"].vector(),
                  field["static"].at_least_zero(),
                  field["dynamic"].at_least_zero(),
                  {}};
  const auto maximum = field.find("max_force");
  if (maximum && !maximum->is_null()) contact.maximum_force = maximum->at_least_zero();
  return contact;
}

Line read_line(std::string_view text, const Origin& origin) {
  std::string id = "null";
  try {
    const Json json = parse_json(text, origin);
    id = id_of(json);
    const Field field(json, origin);
    if (has_key(json, "scene") && !has_key(json, "ask")) return read_scene_line(field);
    field.object();
    if (has_key(json, "hello") && !has_key(json, "ask")) return read_hello(field);
    return AskLine{id, read_ask(field)};
  } catch (const BadInput& bad) {
    return BadLine{id, bad.what()};
  }
}

}  // namespace groundtruth
