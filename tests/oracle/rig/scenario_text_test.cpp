#include <groundtruth/rig/scenario_text.hpp>

#include <fstream>

#include <gtest/gtest.h>

#include <groundtruth/rig/builtin_scenarios.hpp>

namespace groundtruth::rig {
namespace {

Scenario read(const std::string& text) { return read_scenario(text, {"run.json", 1}, "."); }

std::string refusal_of(const std::string& text) {
  try {
    read(text);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "read";
}

const std::string plain = R"({"groundtruth": "scenario/1",
"machine": {"mass": 1200, "inertia": [1000, 1500, 2000], "wheels": [{"wheel": {"k_xy": -1e6, "k_z": -1e6, "d_xy": -1e3, "d_z": -1e3, "z_min": 0.2, "z_zero": 0.8, "z_max": 0.8, "tyre": "rubber"}, "place": [1, 0, 0.3]}]},
"start": {"position": [0, 0, 2], "orientation": [0, 1, 0, 0]},
"scene": {"groundtruth": "scene/1", "shape": {"halfspace": [0, 0, 1, 0]}},
"inputs": {"brake": 7}, "h": 0.004, "duration": 10})";

std::string with(std::string what, const std::string& instead) {
  std::string text = plain;
  return text.replace(text.find(what), what.size(), instead);
}

TEST(ScenarioText, EveryBuiltInScenarioReadsBackToWhatWasWritten) {
  for (const Scenario& scenario : builtin_scenarios()) {
    const std::string text = write_scenario(scenario);
    const Scenario back = read(text);
    EXPECT_EQ(write_scenario(back), text) << scenario.name;
    EXPECT_EQ(back.start.position_in_world, scenario.start.position_in_world);
    EXPECT_EQ(back.start_wheels, scenario.start_wheels);
    EXPECT_EQ(back.machine.turns(), scenario.machine.turns());
    EXPECT_EQ(back.h, scenario.h);
  }
}

TEST(ScenarioText, WhatMayBeAbsentIsAsTheHeaderSays) {
  const Scenario scenario = read(plain);
  EXPECT_EQ(scenario.name, "run");
  EXPECT_EQ(scenario.integrator, Integrator::semi_implicit);
  EXPECT_EQ(scenario.machine.wheels[0].brake_share, 1);
  EXPECT_EQ(scenario.machine.wheels[0].steering_share, 0);
  EXPECT_TRUE(scenario.start_wheels.empty());
  EXPECT_EQ(scenario.start.velocity_in_world, Eigen::Vector3d::Zero());
  EXPECT_EQ(scenario.inputs.at(3).brake, 7);
  EXPECT_EQ(scenario.inputs.at(3).gravity_in_world, Eigen::Vector3d(0, 0, -9.81));
}

TEST(ScenarioText, InputsAreNumbersPointsOrWavesUponThem) {
  const auto brake = [](const std::string& input, double time) {
    return read(with("7", input)).inputs.at(time).brake;
  };
  EXPECT_EQ(brake("\"0x1p3\"", 5), 8);
  EXPECT_EQ(brake("[]", 5), 0);
  EXPECT_EQ(brake("[[1, 10], [3, 20]]", 0), 10);
  EXPECT_EQ(brake("[[1, 10], [3, 20]]", 2), 15);
  EXPECT_EQ(brake("[[1, 10], [3, 20]]", 4), 20);
  EXPECT_EQ(brake("[[1, 10], [1, 20]]", 0.5), 10) << "two points of one time are a jump";
  EXPECT_EQ(brake("[[1, 10], [1, 20]]", 1), 20);
  EXPECT_DOUBLE_EQ(brake(R"({"points": 10, "amplitude": 2, "frequency": 0.25})", 1), 12);
}

TEST(ScenarioText, ABodyThatDoesNotTurnHasNoInertia) {
  EXPECT_FALSE(read(with("[1000, 1500, 2000]", "null")).machine.turns());
  EXPECT_TRUE(read(plain).machine.turns());
}

TEST(ScenarioText, TheSceneMayBeAFileBesideIt) {
  const std::string folder = ::testing::TempDir();
  std::ofstream(folder + "/ground.json")
      << R"({"groundtruth": "scene/1", "shape": {"halfspace": [0, 0, 1, 5]}})";
  std::ofstream(folder + "/run.json")
      << with(R"({"groundtruth": "scene/1", "shape": {"halfspace": [0, 0, 1, 0]}})", "\"ground.json\"");
  const Scenario scenario = read_scenario_file(folder + "/run.json");
  EXPECT_EQ(std::get<HalfSpace>(scenario.scene.shape.expression).offset, 5);
}

struct Refused {
  const char* what;
  const char* instead;
  const char* message;
};

class ScenarioTextRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(ScenarioTextRefuses, NamingFileLineFieldAndValue) {
  EXPECT_EQ(refusal_of(with(GetParam().what, GetParam().instead)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, ScenarioTextRefuses,
    ::testing::Values(
        Refused{"\"scenario/1\"", "\"scenario/2\"",
                "run.json:1: groundtruth: \"scenario/2\" is not \"scenario/1\""},
        Refused{"\"mass\": 1200", "\"mass\": 0", "run.json:2: machine.mass: 0 is not > 0"},
        Refused{"\"mass\": 1200", "\"mass\": 1e400",
                "run.json:2: machine.mass: 1e400 lies outside the range of doubles"},
        Refused{"\"mass\": 1200", "\"mass\": 1, \"mass\": 2",
                "run.json:2: machine.mass: the key stands here twice"},
        Refused{"\"mass\": 1200", "\"mass\": 1, \"colour\": 2", "run.json:2: machine.colour: unknown key"},
        Refused{"1500,", "-1500,", "run.json:2: machine.inertia[1]: -1500 is not > 0"},
        Refused{"\"k_xy\": -1e6", "\"k_xy\": 1e6",
                "run.json:2: machine.wheels[0].wheel.k_xy: 1e+06 is not < 0"},
        Refused{"[0, 1, 0, 0]", "[0, 0, 0, 0]",
                "run.json:3: start.orientation: [0, 0, 0, 0] is the zero quaternion"},
        Refused{"[0, 1, 0, 0]", "[0, 1, 0, 0], \"wheels\": []",
                "run.json:3: start.wheels: an array of 0 is not an array of 1"},
        Refused{"{\"brake\": 7}", "{\"brake\": [[2, 1], [1, 1]]}",
                "run.json:5: inputs.brake[1][0]: 1 is before the point before"},
        Refused{"{\"brake\": 7}", "{\"brake\": {\"points\": 1, \"amplitude\": 2, \"frequency\": 1}}",
                "run.json:5: inputs.brake: falls below 0"},
        Refused{"{\"brake\": 7}", "{\"push\": [0, 0]}",
                "run.json:5: inputs.push: an array of 2 is not an array of 3"},
        Refused{"{\"brake\": 7}", "{\"brake\": true}", "run.json:5: inputs.brake: true is not a number"},
        Refused{"\"h\": 0.004", "\"h\": 0", "run.json:5: h: 0 is not > 0"},
        Refused{"\"h\": 0.004", "\"h\": 1e-300", "run.json:5: duration: 10 is more than 2^53 steps of h"},
        Refused{"\"h\": 0.004", "\"h\": 1, \"integrator\": \"euler\"",
                "run.json:5: integrator: \"euler\" is none of semi-implicit, half-kick, implicit"}));

}  // namespace
}  // namespace groundtruth::rig
