#include <groundtruth/rig/scenario_text.hpp>
#include <groundtruth/text/json_writer.hpp>
#include <groundtruth/text/scene_text.hpp>
#include <groundtruth/text/state_writer.hpp>
#include <groundtruth/text/wheel_text.hpp>

namespace groundtruth::rig {
namespace {

Vector to_array(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

void write_mounted_wheel(JsonWriter& writer, const MountedWheel& mounted) {
  writer.open_object();
  writer.key("wheel");
  write_wheel(writer, mounted.wheel);
  writer.member("place", to_array(mounted.place_in_body));
  writer.member("brake_share", mounted.brake_share);
  writer.member("steering_share", mounted.steering_share);
  writer.close_object();
}

void write_machine(JsonWriter& writer, const Machine& machine) {
  writer.open_object();
  writer.member("mass", machine.mass);
  writer.key("inertia");
  machine.turns() ? writer.numbers(to_array(machine.inertia)) : writer.null();
  writer.key("wheels");
  writer.open_array();
  for (const MountedWheel& mounted : machine.wheels) write_mounted_wheel(writer, mounted);
  writer.close_array();
  writer.close_object();
}

void write_start(JsonWriter& writer, const Scenario& scenario) {
  const BodyState& body = scenario.start;
  const Eigen::Quaterniond& q = body.world_from_body;
  writer.open_object();
  writer.member("position", to_array(body.position_in_world));
  writer.member("orientation", Quaternion{q.w(), q.x(), q.y(), q.z()});
  writer.member("velocity", to_array(body.velocity_in_world));
  writer.member("angular_velocity", to_array(body.angular_velocity_in_world));
  if (!scenario.start_wheels.empty()) {
    writer.key("wheels");
    writer.open_array();
    for (const WheelState& wheel : scenario.start_wheels) write_state(writer, wheel);
    writer.close_array();
  }
  writer.close_object();
}

void write_points(JsonWriter& writer, const Signal& signal) {
  writer.open_array();
  for (const auto& [time, value] : signal.points) writer.numbers(std::array<double, 2>{time, value});
  writer.close_array();
}

void write_signal(JsonWriter& writer, const Signal& signal) {
  if (signal.amplitude == 0 && signal.frequency == 0) return write_points(writer, signal);
  writer.open_object();
  writer.key("points");
  write_points(writer, signal);
  writer.member("amplitude", signal.amplitude);
  writer.member("frequency", signal.frequency);
  writer.close_object();
}

void write_signals(JsonWriter& writer, std::string_view key, const std::array<Signal, 3>& signals) {
  writer.key(key);
  writer.open_array();
  for (const Signal& signal : signals) write_signal(writer, signal);
  writer.close_array();
}

void write_inputs(JsonWriter& writer, const Inputs& inputs) {
  writer.open_object();
  writer.key("brake");
  write_signal(writer, inputs.brake);
  writer.key("steering");
  write_signal(writer, inputs.steering);
  write_signals(writer, "thrust", inputs.thrust_in_body);
  write_signals(writer, "push", inputs.push_in_world);
  write_signals(writer, "gravity", inputs.gravity_in_world);
  writer.close_object();
}

}  // namespace

std::string write_scenario(const Scenario& scenario) {
  JsonWriter writer;
  writer.open_object();
  writer.member("groundtruth", "scenario/1");
  writer.member("name", scenario.name);
  writer.member("description", scenario.description);
  writer.key("machine");
  write_machine(writer, scenario.machine);
  writer.key("start");
  write_start(writer, scenario);
  writer.key("scene");
  writer.json(write_scene(scenario.scene));
  writer.key("inputs");
  write_inputs(writer, scenario.inputs);
  writer.member("integrator", name_of(scenario.integrator));
  writer.member("h", scenario.h);
  writer.member("duration", scenario.duration);
  writer.close_object();
  return writer.take();
}

}  // namespace groundtruth::rig
