#include <groundtruth/text/scene_text.hpp>

#include <gtest/gtest.h>

namespace groundtruth {
namespace {

Scene read(const std::string& text) { return read_scene(text, {"house.json", 1}); }

Scene scene_of(const std::string& shape) {
  return read(R"({"groundtruth": "scene/1", "materials": {"dry": {}}, "shape": )" + shape + "}");
}

std::string refusal_of(const std::string& text) {
  try {
    read(text);
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "read";
}

std::string refusal_of_shape(const std::string& shape) {
  return refusal_of("{\"groundtruth\": \"scene/1\",\n\"shape\": " + shape + "}");
}

TEST(SceneText, ABoxIsSixHalfSpacesInTheOrderOfTheContract) {
  const Scene scene = scene_of(R"({"box": [[1, 2, 3], [4, 5, 6]]})");
  const auto& faces = std::get<Intersection>(scene.shape.expression).operands;
  const std::vector<HalfSpace> expected = {{{-1, 0, 0}, -1}, {{1, 0, 0}, 4},   {{0, -1, 0}, -2},
                                           {{0, 1, 0}, 5},   {{0, 0, -1}, -3}, {{0, 0, 1}, 6}};
  ASSERT_EQ(faces.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(std::get<HalfSpace>(faces[i].expression), expected[i]);
}

TEST(SceneText, ReadsWhatItWrote) {
  const std::string text =
      R"({"groundtruth":"scene/1","materials":{"dry":{"friction":{"metal":{"static":0.3,"dynamic":0.2},)"
      R"("rubber":{"static":0.5,"dynamic":0.4}},"max_force":1e+07},"wet":{"friction":{}}},)"
      R"("shape":{"union":[{"halfspace":[0,0,1,0.1]},"everything","nothing",{"intersection":[]},)"
      R"({"material":"dry","shape":{"paint":"wet","where":{"halfspace":[1,0,0,5e-324]},"shape":{"union":[]}}}]}})";
  EXPECT_EQ(write_scene(read(text)), text);
}

TEST(SceneText, NumbersMayBeHexFloats) {
  const Scene scene = scene_of(R"({"halfspace": ["0x1.8p+0", 0, "-0x1p-1074", 1]})");
  EXPECT_EQ(std::get<HalfSpace>(scene.shape.expression), (HalfSpace{{1.5, 0, -0x1p-1074}, 1}));
}

TEST(SceneText, MaterialsMayBeAbsentAndMaximumForceNull) {
  EXPECT_TRUE(read(R"({"groundtruth": "scene/1", "shape": "nothing"})").materials.empty());
  const Scene scene =
      read(R"({"groundtruth": "scene/1", "materials": {"a": {"max_force": null}}, "shape": "nothing"})");
  EXPECT_EQ(scene.materials[0].maximum_force, std::nullopt);
}

struct Refused {
  const char* shape;
  const char* message;
};

TEST(SceneText, RefusesNamingFileLineFieldAndValue) {
  const Refused cases[] = {
      {R"({"union": ["nothing",
 {"halfspace": [0, 0, true, 1]}]})",
       "house.json:3: shape.union[1].halfspace[2]: true is not a number"},
      {R"({"halfspace": [0, 0, 1e400, 1]})",
       "house.json:2: shape.halfspace[2]: 1e400 lies outside the range of doubles"},
      {R"({"halfspace": [0, 0, 9007199254740993, 1]})",
       "house.json:2: shape.halfspace[2]: 9007199254740993 is an integer that no double equals"},
      {R"({"halfspace": [0, 0, "1.5", 1]})",
       "house.json:2: shape.halfspace[2]: 1.5 is not a hex float (\"0x1.8p+0\")"},
      {R"({"halfspace": [0, 0, 1]})", "house.json:2: shape.halfspace: an array of 3 is not an array of 4"},
      {R"({"box": [[0, 0, 0]]})", "house.json:2: shape.box: an array of 1 is not an array of 2"},
      {R"({"ball": [0, 0, 0, 1]})", "house.json:2: shape.ball: unknown key"},
      {R"({"union": [], "union": []})", "house.json:2: shape.union: the key stands here twice"},
      {R"({"union": {}})", "house.json:2: shape.union: an object is not an array"},
      {R"({"material": "ice", "shape": "nothing"})",
       "house.json:2: shape.material: \"ice\" is not in materials"},
      {R"({"shape": "nothing"})", "house.json:2: shape.shape: unknown key"},
      {R"("anything")", "house.json:2: shape: \"anything\" is no shape"},
      {R"(null)", "house.json:2: shape: null is not an object"},
      {R"({})", "house.json:2: shape: an empty object is no shape"},
  };
  for (const auto& [shape, message] : cases) EXPECT_EQ(refusal_of_shape(shape), message);
}

TEST(SceneText, RefusesOtherVersionsAndStrayText) {
  EXPECT_EQ(refusal_of(R"({"groundtruth": "scene/2", "shape": "nothing"})"),
            "house.json:1: groundtruth: \"scene/2\" is not \"scene/1\"");
  EXPECT_EQ(refusal_of(R"({"shape": "nothing"})"), "house.json:1: groundtruth is missing");
  EXPECT_EQ(refusal_of(R"({"groundtruth": "scene/1", "shape": "nothing", "unit": "m"})"),
            "house.json:1: unit: unknown key");
  EXPECT_TRUE(refusal_of("{\"groundtruth\": \"scene/1\", \"shape\": \"nothing\"}\n}")
                  .starts_with("house.json:2: not JSON: "));
  EXPECT_TRUE(refusal_of("{\"groundtruth\": NaN}").starts_with("house.json:1: not JSON: "));
  EXPECT_TRUE(refusal_of("{\"groundtruth\": 01}").starts_with("house.json:1: not JSON: "));
  EXPECT_TRUE(refusal_of("{\"groundtruth\": \"\xff\"}").starts_with("house.json:1: not JSON: "));
  EXPECT_EQ(refusal_of(std::string("{}\0{}", 5)), "house.json:1: the text contains a NUL character");
  EXPECT_EQ(refusal_of(R"({"groundtruth": "scene/1", "materials": {"a": {"friction": {"rubber": {"static": -1,
"dynamic": 0}}}}, "shape": "nothing"})"),
            "house.json:1: materials.a.friction.rubber.static: -1 is not >= 0");
}

std::string nested(std::size_t depth) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += R"({"union":[)";
  text += "\"nothing\"";
  for (std::size_t i = 0; i < depth; ++i) text += "]}";
  return text;
}

TEST(SceneText, RefusesDepthBeyondAThousand) {
  EXPECT_NO_THROW(scene_of(nested(999)));
  EXPECT_TRUE(refusal_of_shape(nested(1000)).ends_with("[0]: shapes are nested deeper than 1000"));
  EXPECT_EQ(refusal_of_shape(nested(100000)), "house.json:2: nested deeper than 2010 levels");
}

TEST(SceneText, AMissingFileIsNamed) {
  try {
    read_scene_file("/nowhere/house.json");
    FAIL();
  } catch (const BadInput& bad) {
    EXPECT_STREQ(bad.what(), "/nowhere/house.json:0: cannot be read");
  }
}

}  // namespace
}  // namespace groundtruth
