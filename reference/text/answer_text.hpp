#pragma once
// Answers as text, one JSON object a line (SPEC section 8).

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>
#include <groundtruth/text/bad_input.hpp>

namespace groundtruth {

// The line of an answer, without line end; a Refusal becomes an error. `id` is JSON. `scene` names the
// materials; it is the one that was asked about.
std::string write_answer(const std::string& id, const Answer& answer, const Evidence& evidence,
                         const Scene& scene);

// The line of an ask that could not be read.
std::string write_error(const std::string& id, const std::string& problem);

// The answer to a hello.
std::string write_hello(const std::string& name);

// What the answer to a hello says.
struct HelloAnswer {
  std::string version;                           // "answers/1"
  std::string name;                              // empty if it gives none
  std::optional<std::vector<std::string>> asks;  // the kinds that are answered; absent if it does not say
};

// Throws BadInput on text that is no object with a `hello`; whatever else it holds is ignored if it is not as
// it should be.
HelloAnswer read_hello(std::string_view text, const Origin& origin);

// The id of any line, as JSON; null if it has none that is a string or a number, or is no JSON object.
std::string read_id(std::string_view text);

struct AnswerLine {
  std::string id;  // JSON
  std::variant<Answer, Refusal> answer;
  Evidence evidence;
};

// Reads the answer to an ask of this kind about this scene. Throws BadInput on text that is none; extra keys
// are ignored, as engines may add to an answer.
AnswerLine read_answer(std::string_view text, const Ask& ask, const Scene& scene, const Origin& origin);

// The id of a line, as JSON; null if it has none or is no JSON object.
std::string read_answer_id(std::string_view text);

}  // namespace groundtruth
