#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/json_writer.hpp>
#include <groundtruth/text/scene_text.hpp>
#include <groundtruth/text/state_writer.hpp>
#include <groundtruth/text/wheel_text.hpp>

namespace groundtruth {
namespace {

void write_members(JsonWriter& writer, const EntryAsk& ask) {
  writer.member("from", ask.from);
  writer.member("to", ask.to);
  writer.member("range", std::array<double, 2>{ask.lambda_first, ask.lambda_last});
}

void write_members(JsonWriter& writer, const ClipAsk& ask) {
  writer.member("force", ask.force_in_wheel);
  writer.member("normal", ask.normal_in_wheel);
  writer.member("friction", ask.friction);
  writer.member("brake", ask.brake);
  writer.member("min_uprightness", ask.min_uprightness);
}

void write_frame(JsonWriter& writer, const Frame& frame) {
  writer.open_object();
  writer.member("position", frame.position_in_world);
  writer.member("orientation", frame.world_from_wheel);
  writer.member("velocity", frame.velocity_in_world);
  writer.member("angular_velocity", frame.angular_velocity_in_world);
  writer.close_object();
}

void write_members(JsonWriter& writer, const StepAsk& ask) {
  writer.key("wheel");
  write_wheel(writer, ask.wheel);
  writer.key("frame");
  write_frame(writer, ask.frame);
  writer.member("brake", ask.brake);
  writer.member("h", ask.h);
  writer.key("state");
  write_state(writer, ask.state);
}

}  // namespace

std::string_view kind_of(const Ask& ask) {
  constexpr std::array<std::string_view, 3> kinds = {"entry", "clip", "step"};
  return kinds[ask.index()];
}

std::string write_ask(const std::string& id, const Ask& ask) {
  JsonWriter writer;
  writer.open_object();
  writer.key("id");
  writer.json(id);
  writer.member("ask", kind_of(ask));
  std::visit([&](const auto& members) { write_members(writer, members); }, ask);
  writer.close_object();
  return writer.take();
}

std::string write_scene_line(const Scene& scene) { return "{\"scene\":" + write_scene(scene) + "}"; }

}  // namespace groundtruth
