#pragma once
// Asks as text, one JSON object a line (SPEC section 8).

#include <string>
#include <string_view>
#include <variant>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>
#include <groundtruth/text/bad_input.hpp>

namespace groundtruth {

struct HelloLine {};
struct SceneLine {
  Scene scene;
};
struct SceneFileLine {
  std::string file;  // as written
};
struct AskLine {
  std::string id;  // as JSON: a quoted string, a number or null
  Ask ask;
};
struct BadSceneLine {
  std::string problem;
};
struct BadLine {
  std::string id;  // null if the line has none, or is no JSON object
  std::string problem;
};
using Line = std::variant<HelloLine, SceneLine, SceneFileLine, AskLine, BadSceneLine, BadLine>;

// Never throws on bad text: what is wrong with a line is part of what the line is. `problem` names place,
// line, field and value.
Line read_line(std::string_view text, const Origin& origin);

// The line of an ask or a scene, without line end. `id` is JSON.
std::string write_ask(const std::string& id, const Ask& ask);
std::string write_scene_line(const Scene& scene);

// The word that names the kind of an ask: "entry", "clip", "step".
std::string_view kind_of(const Ask& ask);

}  // namespace groundtruth
