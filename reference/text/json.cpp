#include <groundtruth/text/json.hpp>

#include <algorithm>
#include <map>

#define RAPIDJSON_HAS_STDSTRING 1
#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

namespace groundtruth {
namespace {

// RapidJSON copies streams that it knows and then reports stale positions to the handler; of this one it
// keeps no copy, so that tell() is where the value just parsed ends.
class PositionedText {
 public:
  using Ch = char;
  explicit PositionedText(std::string_view text) : text_(text) {}
  Ch Peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }
  Ch Take() {
    const Ch character = Peek();
    ++position_;
    return character;
  }
  std::size_t Tell() const { return std::min(position_, text_.size()); }
  Ch* PutBegin() { return nullptr; }
  void Put(Ch) {}
  void Flush() {}
  std::size_t PutEnd(Ch*) { return 0; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

// Number literals that RapidJSON refuses as too big, by offset. Some of them are doubles all the same.
using SetAside = std::map<std::size_t, std::string>;

class Builder {
 public:
  Builder(std::string_view text, const PositionedText& stream, const SetAside& set_aside,
          std::size_t first_line)
      : text_(text), stream_(stream), set_aside_(set_aside), line_(first_line) {}

  bool too_deep() const { return too_deep_; }
  std::size_t line() { return line_at(stream_.Tell()); }
  Json take() { return std::move(root_); }

  bool Null() { return add(nullptr); }
  bool Bool(bool value) { return add(value); }
  bool RawNumber(const char* text, rapidjson::SizeType length, bool) {
    const auto aside = set_aside_.find(stream_.Tell() - length);
    const ReadNumber read =
        read_decimal(aside == set_aside_.end() ? std::string_view(text, length) : aside->second);
    if (const double* value = std::get_if<double>(&read)) return add(*value);
    return add(std::get<UnreadableNumber>(read));
  }
  bool String(const char* text, rapidjson::SizeType length, bool) { return add(std::string(text, length)); }
  bool Key(const char* text, rapidjson::SizeType length, bool) {
    keys_.back() = std::string(text, length);
    return true;
  }
  bool StartObject() { return open(Json::Object{}); }
  bool StartArray() { return open(Json::Array{}); }
  bool EndObject(rapidjson::SizeType) { return close(); }
  bool EndArray(rapidjson::SizeType) { return close(); }
  // RapidJSON's handler interface also names these; with numbers kept as text they are never called.
  bool Int(int) { return false; }
  bool Uint(unsigned) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }

 private:
  std::size_t line_at(std::size_t offset) {
    line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
    counted_ = offset;
    return line_;
  }

  template <typename Value>
  bool add(Value value) {
    attach({std::move(value), line()});
    return true;
  }

  template <typename Container>
  bool open(Container empty) {
    if (open_.size() == maximum_json_depth) {
      too_deep_ = true;
      return false;
    }
    open_.push_back({std::move(empty), line()});
    keys_.emplace_back();
    return true;
  }

  bool close() {
    Json done = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    attach(std::move(done));
    return true;
  }

  void attach(Json json) {
    if (open_.empty()) {
      root_ = std::move(json);
    } else if (auto* array = std::get_if<Json::Array>(&open_.back().value)) {
      array->push_back(std::move(json));
    } else {
      std::get<Json::Object>(open_.back().value).emplace_back(std::move(keys_.back()), std::move(json));
    }
  }

  std::string_view text_;
  const PositionedText& stream_;
  const SetAside& set_aside_;
  std::size_t line_;
  std::size_t counted_ = 0;
  bool too_deep_ = false;
  Json root_;
  std::vector<Json> open_;
  std::vector<std::string> keys_;  // one an open container
};

constexpr unsigned strict_numbers_as_text = rapidjson::kParseNumbersAsStringsFlag |
                                            rapidjson::kParseValidateEncodingFlag |
                                            rapidjson::kParseIterativeFlag;

// Puts the literal at `offset` aside and a zero of the same width in its place.
void set_literal_aside(std::string& text, std::size_t offset, SetAside& set_aside) {
  const auto end = std::min(text.find_first_not_of("+-.0123456789eE", offset), text.size());
  set_aside.emplace(offset, text.substr(offset, end - offset));
  text[offset] = '0';
  if (end - offset > 1) {
    text[offset + 1] = '.';
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(offset) + 2,
              text.begin() + static_cast<std::ptrdiff_t>(end), '0');
  }
}

}  // namespace

Json parse_json(std::string_view given, const Origin& origin) {
  if (given.find('\0') != std::string_view::npos) {
    throw BadInput(origin.place, origin.first_line, "", "the text contains a NUL character");
  }
  std::string text(given);
  SetAside set_aside;
  while (true) {
    PositionedText stream(text);
    Builder builder(text, stream, set_aside, origin.first_line);
    rapidjson::Reader reader;
    const rapidjson::ParseResult result = reader.Parse<strict_numbers_as_text>(stream, builder);
    if (!result.IsError()) return builder.take();
    constexpr std::size_t most_set_aside = 64;  // each costs another reading of the text
    if (result.Code() == rapidjson::kParseErrorNumberTooBig && set_aside.size() < most_set_aside) {
      set_literal_aside(text, result.Offset(), set_aside);
      continue;
    }
    if (builder.too_deep()) {
      throw BadInput(origin.place, builder.line(), "",
                     "nested deeper than " + std::to_string(maximum_json_depth) + " levels");
    }
    const auto error_at = text.begin() + static_cast<std::ptrdiff_t>(std::min(result.Offset(), text.size()));
    const auto line = origin.first_line + static_cast<std::size_t>(std::count(text.begin(), error_at, '\n'));
    throw BadInput(origin.place, line, "",
                   std::string("not JSON: ") + rapidjson::GetParseError_En(result.Code()));
  }
}

std::string describe(const Json& json) {
  struct Describe {
    std::string operator()(std::nullptr_t) const { return "null"; }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(double value) const { return write_decimal(value); }
    std::string operator()(const UnreadableNumber& number) const {
      return number.problem.substr(0, number.problem.find(' '));
    }
    std::string operator()(const std::string& text) const {
      constexpr std::size_t enough = 40;
      return "\"" + text.substr(0, enough) + (text.size() > enough ? "...\"" : "\"");
    }
    std::string operator()(const Json::Array& array) const {
      return "an array of " + std::to_string(array.size());
    }
    std::string operator()(const Json::Object&) const { return "an object"; }
  };
  return std::visit(Describe{}, json.value);
}

}  // namespace groundtruth
