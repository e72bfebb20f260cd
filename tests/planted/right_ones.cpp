#include <chrono>
#include <thread>

#include <groundtruth/text/json.hpp>

#include "planted_engine.hpp"
#include "ways.hpp"

namespace groundtruth::planted {
namespace {

std::string as_it_is(std::string line) { return line; }

Prepare right() {
  return [](const Scene& scene) -> Answering {
    return [right = std::make_shared<const Right>(scene)](const Ask& ask) { return right->answer(ask); };
  };
}

EntryAnswer on_last_admissible(const Meeting& meeting) { return meeting.on(meeting.admissible.back()); }

Prepare slow() {
  return [](const Scene& scene) -> Answering {
    return [right = std::make_shared<const Right>(scene)](const Ask& ask) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      return right->answer(ask);
    };
  };
}

std::string in_hex(const Json& json);

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string members_in_hex(const Json::Object& object) {
  std::string text;
  for (const auto& [key, value] : object) {
    const auto* number = std::get_if<double>(&value.value);
    const bool is_leaf = number != nullptr && (key == "leaf" || key == "id");
    text +=
        (text.empty() ? "" : ",") + quoted(key) + ":" + (is_leaf ? write_decimal(*number) : in_hex(value));
  }
  return "{" + text + "}";
}

std::string elements_in_hex(const Json::Array& array) {
  std::string text;
  for (const Json& value : array) text += (text.empty() ? "" : ",") + in_hex(value);
  return "[" + text + "]";
}

// Every number but leaf and id as a string, "0x1.8p+0".
std::string in_hex(const Json& json) {
  if (const auto* number = std::get_if<double>(&json.value)) return quoted(write_hex_float(*number));
  if (const auto* text = std::get_if<std::string>(&json.value)) return quoted(*text);
  if (const auto* array = std::get_if<Json::Array>(&json.value)) return elements_in_hex(*array);
  if (const auto* object = std::get_if<Json::Object>(&json.value)) return members_in_hex(*object);
  return "null";
}

std::string line_in_hex(std::string line) { return in_hex(parse_json(line, {"answer", 1})); }

}  // namespace

const std::vector<RightOne>& right_ones() {
  static const std::vector<RightOne> ones{
      {"right", "nothing is odd", right(), as_it_is},
      {"right-other-face", "the last admissible face instead of the first", on_borders(on_last_admissible),
       as_it_is},
      {"right-slow", "sleeps 0.2 ms an ask", slow(), as_it_is},
      {"right-hex", "writes numbers as hex floats", right(), line_in_hex},
  };
  return ones;
}

}  // namespace groundtruth::planted
