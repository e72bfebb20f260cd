#pragma once
// A JSON document that remembers lines and repeated keys, and knows numbers only as doubles that were read
// exactly as SPEC section 8 asks.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <groundtruth/text/bad_input.hpp>
#include <groundtruth/text/number_text.hpp>

namespace groundtruth {

struct Json {
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;  // as written: keys may repeat

  std::variant<std::nullptr_t, bool, double, UnreadableNumber, std::string, Array, Object> value = nullptr;
  std::size_t line = 1;
};

// Shapes nested deeper than this are refused, as every engine walks them recursively.
inline constexpr std::size_t maximum_shape_depth = 1000;

// Of arrays and objects: a shape takes two at the most, and an ask line with a scene has a few around it.
inline constexpr std::size_t maximum_json_depth = 2 * maximum_shape_depth + 10;

// Throws BadInput if the text is not one JSON value and white space, or nests too deep. Numbers that cannot
// be read are kept as such, so that whoever asks for them can name the field.
Json parse_json(std::string_view text, const Origin& origin);

// A value, short enough for a message.
std::string describe(const Json& json);

}  // namespace groundtruth
