#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <groundtruth/rig/scenario_text.hpp>
#include <groundtruth/text/field.hpp>
#include <groundtruth/text/scene_reader.hpp>
#include <groundtruth/text/scene_text.hpp>
#include <groundtruth/text/shared_readers.hpp>
#include <groundtruth/text/wheel_text.hpp>

namespace groundtruth::rig {
namespace {

Eigen::Vector3d read_vector(const Field& field) {
  const Vector v = field.vector();
  return {v[0], v[1], v[2]};
}

double number_or(const std::optional<Field>& field, double otherwise) {
  return field ? field->number() : otherwise;
}

MountedWheel read_mounted_wheel(const Field& field) {
  field.only({"wheel", "place", "brake_share", "steering_share"});
  MountedWheel mounted{read_wheel(field["wheel"]), read_vector(field["place"])};
  if (const auto share = field.find("brake_share")) mounted.brake_share = share->at_least_zero();
  mounted.steering_share = number_or(field.find("steering_share"), mounted.steering_share);
  return mounted;
}

Eigen::Vector3d read_inertia(const Field& field) {
  if (field.is_null()) return Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  field.require_size(3);
  return {field[0].positive(), field[1].positive(), field[2].positive()};
}

Machine read_machine(const Field& field) {
  field.only({"mass", "inertia", "wheels"});
  Machine machine{field["mass"].positive(), read_inertia(field["inertia"]), {}};
  const Field wheels = field["wheels"];
  for (std::size_t i = 0; i < wheels.size(); ++i) machine.wheels.push_back(read_mounted_wheel(wheels[i]));
  return machine;
}

BodyState read_start(const Field& field) {
  field.only({"position", "orientation", "velocity", "angular_velocity", "wheels"});
  BodyState body;
  body.position_in_world = read_vector(field["position"]);
  const Quaternion q = read_orientation(field["orientation"]);
  body.world_from_body = Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  if (const auto velocity = field.find("velocity")) body.velocity_in_world = read_vector(*velocity);
  if (const auto turning = field.find("angular_velocity"))
    body.angular_velocity_in_world = read_vector(*turning);
  return body;
}

std::vector<WheelState> read_states(const Field& field, std::size_t wheels) {
  field.require_size(wheels);
  std::vector<WheelState> states;
  for (std::size_t i = 0; i < wheels; ++i) states.push_back(read_state(field[i]));
  return states;
}

std::vector<std::pair<double, double>> read_points(const Field& field) {
  if (!std::holds_alternative<Json::Array>(field.json().value)) return {{0, field.number()}};
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Field point = field[i];
    point.require_size(2);
    points.emplace_back(point[0].at_least_zero(), point[1].number());
    if (i > 0 && points[i].first < points[i - 1].first) point[0].refuse_value("is before the point before");
  }
  return points;
}

Signal read_signal(const Field& field) {
  if (!std::holds_alternative<Json::Object>(field.json().value)) return {read_points(field)};
  field.only({"points", "amplitude", "frequency"});
  Signal signal{read_points(field["points"]), field["amplitude"].number(),
                field["frequency"].at_least_zero()};
  for (const auto& [time, value] : signal.points)
    if (!std::isfinite(std::abs(value) + std::abs(signal.amplitude)))
      field["amplitude"].refuse_value("leads out of the range of doubles");
  return signal;
}

std::array<Signal, 3> read_signals(const Field& field) {
  field.require_size(3);
  return {read_signal(field[0]), read_signal(field[1]), read_signal(field[2])};
}

Signal read_brake(const Field& field) {
  const Signal signal = read_signal(field);
  double least = signal.points.empty() ? 0 : signal.points.front().second;
  for (const auto& [time, value] : signal.points) least = std::min(least, value);
  if (!(least - std::abs(signal.amplitude) >= 0)) field.refuse("falls below 0");
  return signal;
}

Inputs read_inputs(const std::optional<Field>& field) {
  Inputs inputs;
  inputs.gravity_in_world[2].points = {{0, -9.81}};
  if (!field) return inputs;
  field->only({"brake", "steering", "thrust", "push", "gravity"});
  if (const auto brake = field->find("brake")) inputs.brake = read_brake(*brake);
  if (const auto steering = field->find("steering")) inputs.steering = read_signal(*steering);
  if (const auto thrust = field->find("thrust")) inputs.thrust_in_body = read_signals(*thrust);
  if (const auto push = field->find("push")) inputs.push_in_world = read_signals(*push);
  if (const auto gravity = field->find("gravity")) inputs.gravity_in_world = read_signals(*gravity);
  return inputs;
}

Integrator read_integrator(const Field& field) {
  const auto integrator = integrator_named(field.text());
  if (!integrator) field.refuse_value("is none of semi-implicit, half-kick, implicit");
  return *integrator;
}

Scene read_scene_or_file(const Field& field, const std::filesystem::path& folder) {
  if (field.is_text()) return read_scene_file((folder / field.text()).string());
  field.object();
  return groundtruth::read_scene(field);
}

std::string text_or(const std::optional<Field>& field, const std::string& otherwise) {
  return field ? field->text() : otherwise;
}

}  // namespace

Scenario read_scenario(std::string_view text, const Origin& origin, const std::filesystem::path& folder) {
  const Json json = parse_json(text, origin);
  const Field field(json, origin);
  field.only({"groundtruth", "name", "description", "machine", "start", "scene", "inputs", "integrator", "h",
              "duration"});
  if (field["groundtruth"].text() != "scenario/1") field["groundtruth"].refuse_value("is not \"scenario/1\"");
  Scenario scenario;
  scenario.name = text_or(field.find("name"), std::filesystem::path(origin.place).stem().string());
  scenario.description = text_or(field.find("description"), "");
  scenario.machine = read_machine(field["machine"]);
  const Field start = field["start"];
  scenario.start = read_start(start);
  if (const auto wheels = start.find("wheels"))
    scenario.start_wheels = read_states(*wheels, scenario.machine.wheels.size());
  scenario.scene = read_scene_or_file(field["scene"], folder);
  scenario.inputs = read_inputs(field.find("inputs"));
  if (const auto integrator = field.find("integrator")) scenario.integrator = read_integrator(*integrator);
  scenario.h = field["h"].positive();
  scenario.duration = field["duration"].at_least_zero();
  if (!is_countable(scenario.duration, scenario.h))
    field["duration"].refuse_value("is more than 2^53 steps of h");
  return scenario;
}

Scenario read_scenario_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) throw BadInput(file, 0, "", "cannot be read");
  std::ostringstream text;
  text << stream.rdbuf();
  return read_scenario(text.str(), {file, 1}, std::filesystem::path(file).parent_path());
}

}  // namespace groundtruth::rig
