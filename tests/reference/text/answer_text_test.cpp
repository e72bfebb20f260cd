#include <groundtruth/text/answer_text.hpp>

#include <gtest/gtest.h>

namespace groundtruth {
namespace {

const Scene scene{{{"dry", {}, {}}, {"wet", {}, {}}}, {Nothing{}}};

std::string written(const Answer& answer, const Evidence& evidence = {}) {
  return write_answer("\"a\"", answer, evidence, scene);
}

TEST(AnswerText, WritesWhatTheContractShows) {
  EXPECT_EQ(written(EntryAnswer{Miss{}}), R"({"id":"a","answer":{"kind":"miss"}})");
  EXPECT_EQ(written(EntryAnswer{Inside{0}}, {"0", {}, {}}),
            R"({"id":"a","answer":{"kind":"inside","lambda":0,"lambda_exact":"0"}})");
  EXPECT_EQ(
      written(EntryAnswer{Border{0.25, 3, {0, 0, 1}, 1}}, {"1/4", {3, 5}, {}}),
      R"({"id":"a","answer":{"kind":"border","lambda":0.25,"lambda_exact":"1/4","leaf":3,"normal":[0,0,1],)"
      R"("material":"wet","admissible":[3,5]}})");
  EXPECT_EQ(
      written(EntryAnswer{Border{0.25, 3, {0, 0, -0.0}, std::nullopt}}),
      R"({"id":"a","answer":{"kind":"border","lambda":0.25,"leaf":3,"normal":[0,0,0],"material":null}})");
  EXPECT_EQ(written(ClipAnswer{TooSteep{}}), R"({"id":"a","answer":{"kind":"too_steep"}})");
  EXPECT_EQ(written(ClipAnswer{Clipped{Grip::slip, {1, 2, 3}}}),
            R"({"id":"a","answer":{"kind":"slip","force":[1,2,3]}})");
  EXPECT_EQ(written(StepAnswer{StepFailure::surface_gave_way}),
            R"({"id":"a","answer":{"outcome":"surface_gave_way"}})");
  EXPECT_EQ(
      written(StepAnswer{Stepped{Contact{Grip::stick, {1, 2, 3}, {}, {0, 0, 1}, 0.5, 0.4, {}}, {4, 5, 6}}}),
      R"({"id":"a","answer":{"outcome":"ok","state":{"kind":"stick","pebble":[1,2,3],"velocity":[0,0,0],)"
      R"("normal":[0,0,1],"static":0.5,"dynamic":0.4,"max_force":null},"force":[4,5,6]}})");
  EXPECT_EQ(written(StepAnswer{Refusal{"contact: leaf 0 has no material"}}),
            R"({"id":"a","error":"contact: leaf 0 has no material"})");
  EXPECT_EQ(write_error("null", "a \"b\""), R"({"id":null,"error":"a \"b\""})");
  EXPECT_EQ(write_hello("x"), R"({"hello":"answers/1","name":"x","asks":["entry","clip","step"]})");
}

TEST(AnswerText, ReadsWhatItWrote) {
  const Evidence evidence{"1/3", {1, 2}, {}};
  const Contact contact{Grip::slip, {0.1, 2, 3}, {4, 5, 6}, {0, 0, 1}, 0.5, 0.4, 1e7};
  const std::pair<Ask, Answer> cases[] = {
      {EntryAsk{}, EntryAnswer{Miss{}}},
      {EntryAsk{}, EntryAnswer{Inside{0.1}}},
      {EntryAsk{}, EntryAnswer{Border{1.0 / 3, 1, {0, 0, 1}, 0}}},
      {ClipAsk{}, ClipAnswer{TooSteep{}}},
      {ClipAsk{}, ClipAnswer{Clipped{Grip::stick, {1, 2, 3}}}},
      {StepAsk{}, StepAnswer{StepFailure::wheel_broken}},
      {StepAsk{}, StepAnswer{Stepped{contact, {7, 8, 9}}}},
      {StepAsk{}, StepAnswer{Stepped{Free{}, {}}}},
  };
  for (const auto& [ask, answer] : cases) {
    const AnswerLine read = read_answer(written(answer, evidence), ask, scene, {"answers.jsonl", 1});
    EXPECT_EQ(read.id, "\"a\"");
    EXPECT_EQ(std::get<Answer>(read.answer), answer);
  }
  const AnswerLine error = read_answer(R"({"id":"a","error":"no"})", EntryAsk{}, scene, {"answers.jsonl", 1});
  EXPECT_EQ(std::get<Refusal>(error.answer).reason, "no");
}

TEST(AnswerText, RefusesWhatIsNoAnswer) {
  for (const char* text :
       {"", "[]", "{}", R"({"id":"a","answer":{"kind":"hit"}})", R"({"id":"a","answer":{}})",
        R"({"id":"a","answer":{"kind":"inside","lambda":null}})",
        R"({"id":"a","answer":{"kind":"border","lambda":0,"leaf":-1,"normal":[0,0,1],"material":null}})",
        R"({"id":"a","answer":{"kind":"border","lambda":0,"leaf":0,"normal":[0,0,1],"material":"mud"}})"}) {
    EXPECT_THROW(read_answer(text, EntryAsk{}, scene, {"answers.jsonl", 1}), BadInput) << text;
  }
}

TEST(AnswerText, ReadsTheHelloItWrote) {
  const HelloAnswer hello = read_hello(write_hello("mine"), {"test"});
  EXPECT_EQ(hello.version, "answers/1");
  EXPECT_EQ(hello.name, "mine");
  EXPECT_EQ(hello.asks, (std::vector<std::string>{"entry", "clip", "step"}));
}

TEST(AnswerText, ReadsHelloWithWhatItDoesNotSayLeftOut) {
  const HelloAnswer hello = read_hello(R"({"hello":"answers/2","name":7,"more":[]})", {"test"});
  EXPECT_EQ(hello.version, "answers/2");
  EXPECT_EQ(hello.name, "");
  EXPECT_FALSE(hello.asks.has_value());
  EXPECT_THROW(read_hello(R"({"name":"mine"})", {"test"}), BadInput);
  EXPECT_THROW(read_hello("hello", {"test"}), BadInput);
}

TEST(AnswerText, ReadsTheIdOfAnyLine) {
  EXPECT_EQ(read_id(R"({"id":"a1","nonsense":{}})"), "\"a1\"");
  EXPECT_EQ(read_id(R"({"id":7})"), "7");
  EXPECT_EQ(read_id(R"({"id":[]})"), "null");
  EXPECT_EQ(read_id("{\"id\":"), "null");
}

}  // namespace
}  // namespace groundtruth
