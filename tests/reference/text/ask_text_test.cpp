#include <groundtruth/text/ask_text.hpp>

#include <gtest/gtest.h>

namespace groundtruth {
namespace {

Line read(const std::string& text) { return read_line(text, {"asks.jsonl", 7}); }

template <typename Kind>
Kind ask_of(const std::string& text) {
  const Line line = read(text);
  const auto* bad = std::get_if<BadLine>(&line);
  EXPECT_EQ(bad, nullptr) << bad->problem;
  return bad == nullptr ? std::get<Kind>(std::get<AskLine>(line).ask) : Kind{};
}

const std::string wheel =
    R"({"k_xy":-100000,"k_z":-90000,"d_xy":-1000,"d_z":0,"z_min":0.2,"z_zero":0.7,"z_max":0.8,"tyre":"rubber"})";
const std::string frame = R"({"position":[1,2,3],"orientation":[0,1,0,0],"velocity":[4,5,6]})";

std::string step_with(const std::string& state) {
  return R"({"id":"s","ask":"step","wheel":)" + wheel + R"(,"frame":)" + frame +
         R"(,"brake":10,"h":0.01,"state":)" + state + "}";
}

TEST(AskText, ARangeMayBeAbsent) {
  const EntryAsk ask = ask_of<EntryAsk>(R"({"id":"a","ask":"entry","from":[1,2,3],"to":[4,5,6]})");
  EXPECT_EQ(ask.from, (Vector{1, 2, 3}));
  EXPECT_EQ(ask.to, (Vector{4, 5, 6}));
  EXPECT_EQ(ask.lambda_first, 0);
  EXPECT_EQ(ask.lambda_last, 1);
}

TEST(AskText, AClipHasADefaultUprightness) {
  const std::string start =
      R"({"id":1,"ask":"clip","force":[1,2,3],"normal":[0,0,-1],"friction":0.5,"brake":2)";
  EXPECT_EQ(ask_of<ClipAsk>(start + "}").min_uprightness, 0.1);
  EXPECT_EQ(ask_of<ClipAsk>(start + R"(,"min_uprightness":0.25})").min_uprightness, 0.25);
}

TEST(AskText, AStepBearsItsState) {
  EXPECT_EQ(ask_of<StepAsk>(step_with(R"({"kind":"free"})")).state, WheelState{Free{}});
  const Contact contact{Grip::slip, {1, 2, 3}, {4, 5, 6}, {0, 0, 1}, 0.5, 0.4, std::nullopt};
  EXPECT_EQ(
      ask_of<StepAsk>(step_with(R"({"kind":"slip","pebble":[1,2,3],"velocity":[4,5,6],"normal":[0,0,1],)"
                                R"("static":0.5,"dynamic":0.4,"max_force":null})"))
          .state,
      WheelState{contact});
}

TEST(AskText, ReadsWhatItWrote) {
  for (const std::string& text :
       {std::string(R"({"id":"a\"1","ask":"entry","from":[0.1,2,3],"to":[4,5,5e-324],"range":[-1,1e+300]})"),
        std::string(R"({"id":17,"ask":"clip","force":[1,2,3],"normal":[0,0,-1],"friction":0.5,"brake":2,)"
                    R"("min_uprightness":0.1})")}) {
    const Line line = read(text);
    const auto& [id, ask] = std::get<AskLine>(line);
    EXPECT_EQ(write_ask(id, ask), text);
  }
  const Line line = read(step_with(R"({"kind":"stick","pebble":[1,2,3],"velocity":[0,0,0],"normal":[0,0,1],)"
                                   R"("static":0.5,"dynamic":0.4,"max_force":5})"));
  const std::string written = write_ask("\"s\"", std::get<AskLine>(line).ask);
  EXPECT_EQ(write_ask("\"s\"", std::get<AskLine>(read(written)).ask), written);
}

TEST(AskText, KnowsHelloAndScenes) {
  EXPECT_TRUE(std::holds_alternative<HelloLine>(read(R"({"hello": "answers/1"})")));
  EXPECT_EQ(std::get<SceneFileLine>(read(R"({"scene": "a.json"})")).file, "a.json");
  EXPECT_TRUE(
      std::holds_alternative<SceneLine>(read(R"({"scene": {"groundtruth":"scene/1","shape":"nothing"}})")));
  EXPECT_EQ(std::get<BadSceneLine>(read(R"({"scene": {"groundtruth":"scene/1"}})")).problem,
            "asks.jsonl:7: scene: shape is missing");
}

struct Refused {
  std::string line;
  const char* id;
  const char* problem;
};

TEST(AskText, RefusesNamingFileLineFieldAndValue) {
  const Refused cases[] = {
      {R"({"id":"a","ask":"entry","from":[0,0,1e999],"to":[0,0,0]})", "\"a\"",
       "asks.jsonl:7: from[2]: 1e999 lies outside the range of doubles"},
      {R"({"from":[0,0,1e999],"ask":"entry","to":[0,1e999,0],"id":"last"})", "\"last\"",
       "asks.jsonl:7: from[2]: 1e999 lies outside the range of doubles"},
      {R"({"id":"a","ask":"entry","from":[0,0,0]})", "\"a\"", "asks.jsonl:7: to is missing"},
      {R"({"id":"a","ask":"entry","from":[0,0,0],"to":[0,0,0],"range":[1,0]})", "\"a\"",
       "asks.jsonl:7: range: [1, 0]: the first is larger than the second"},
      {R"({"id":"a","ask":"entry","from":[0,0,0],"to":[0,0,0],"speed":1})", "\"a\"",
       "asks.jsonl:7: speed: unknown key"},
      {R"({"id":"a","ask":"clip","force":[1,2,3],"normal":[0,0,-1],"friction":-0.5,"brake":1})", "\"a\"",
       "asks.jsonl:7: friction: -0.5 is not >= 0"},
      {R"({"id":"a","ask":"fly"})", "\"a\"", "asks.jsonl:7: ask: \"fly\" is no ask"},
      {R"({"id":"a"})", "\"a\"", "asks.jsonl:7: ask is missing"},
      {R"({"id":"a","id":"b","ask":"entry"})", "\"a\"", "asks.jsonl:7: id: the key stands here twice"},
      {R"({"hello":"answers/2"})", "null", "asks.jsonl:7: hello: \"answers/2\" is not \"answers/1\""},
      {"[1,2]", "null", "asks.jsonl:7: an array of 2 is not an object"},
      {step_with(R"({"kind":"stuck"})"), "\"s\"",
       "asks.jsonl:7: state.kind: \"stuck\" is neither free nor stick nor slip"},
      {step_with(R"({"kind":"free","pebble":[0,0,0]})"), "\"s\"", "asks.jsonl:7: state.pebble: unknown key"},
  };
  for (const auto& [text, id, problem] : cases) {
    const Line line = read(text);
    ASSERT_TRUE(std::holds_alternative<BadLine>(line)) << text;
    EXPECT_EQ(std::get<BadLine>(line).id, id);
    EXPECT_EQ(std::get<BadLine>(line).problem, problem);
  }
}

TEST(AskText, ALineThatIsNoJsonHasNoId) {
  for (const char* text : {"", "{", "entry", "{\"id\": \"a\"} {}"}) {
    const Line line = read(text);
    ASSERT_TRUE(std::holds_alternative<BadLine>(line)) << text;
    EXPECT_EQ(std::get<BadLine>(line).id, "null");
    EXPECT_TRUE(std::get<BadLine>(line).problem.starts_with("asks.jsonl:7: not JSON: "));
  }
}

// Each constraint on a wheel and a frame, broken alone.
TEST(AskText, RefusesWheelsAndFramesThatCannotBe) {
  const std::pair<std::string, std::string> replacements[] = {
      {R"("k_xy":-100000)", R"("k_xy":0)"},
      {R"("k_z":-90000)", R"("k_z":1)"},
      {R"("d_xy":-1000)", R"("d_xy":1)"},
      {R"("d_z":0)", R"("d_z":0.5)"},
      {R"("z_min":0.2)", R"("z_min":0.7)"},
      {R"("z_zero":0.7)", R"("z_zero":0.9)"},
      {R"("tyre":"rubber")", R"("tyre":3)"},
      {R"([0,1,0,0])", R"([0,0,0,0])"},
      {R"("brake":10)", R"("brake":-1)"},
      {R"("h":0.01)", R"("h":0)"},
      {R"("tyre":"rubber")", R"("tyre":"rubber","relocation":"teleport")"},
      {R"("tyre":"rubber")", R"("tyre":"rubber","min_uprightness":0)"},
  };
  for (const auto& [good, bad] : replacements) {
    std::string text = step_with(R"({"kind":"free"})");
    ASSERT_NE(text.find(good), std::string::npos);
    text.replace(text.find(good), good.size(), bad);
    EXPECT_TRUE(std::holds_alternative<BadLine>(read(text))) << text;
  }
}

}  // namespace
}  // namespace groundtruth
