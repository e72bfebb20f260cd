#pragma once
// JSON objects in a line. Private to this folder.

#include <string>
#include <string_view>

#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <groundtruth/text/bad_input.hpp>

namespace groundtruth::validation {

class ObjectWriter {
 public:
  ObjectWriter() { writer_.StartObject(); }
  std::string take() {
    writer_.EndObject();
    return {buffer_.GetString(), buffer_.GetSize()};
  }

  void key(std::string_view name) { writer_.Key(name.data(), static_cast<rapidjson::SizeType>(name.size())); }
  void text(std::string_view name, std::string_view value) {
    key(name);
    writer_.String(value.data(), static_cast<rapidjson::SizeType>(value.size()));
  }
  void json(std::string_view name, std::string_view value) {
    key(name);
    writer_.RawValue(value.data(), value.size(), rapidjson::kObjectType);
  }
  void count(std::string_view name, std::uint64_t value) {
    key(name);
    writer_.Uint64(value);
  }
  void seconds(std::string_view name, double value) {
    constexpr int microseconds = 6;
    writer_.SetMaxDecimalPlaces(microseconds);
    key(name);
    writer_.Double(value);
  }

 private:
  rapidjson::StringBuffer buffer_;
  rapidjson::Writer<rapidjson::StringBuffer> writer_{buffer_};
};

// A line that is one JSON object. What it lacks, or has of another type, is a BadInput.
class ObjectReader {
 public:
  ObjectReader(std::string_view text, const Origin& origin);

  bool has(const char* name) const { return document_.HasMember(name); }
  std::string text(const char* name) const;
  std::string json(const char* name) const;  // as JSON of the same meaning; doubles keep their bits
  std::uint64_t count(const char* name) const;
  double number(const char* name) const;
  [[noreturn]] void refuse(const std::string& field, const std::string& problem) const;

 private:
  const rapidjson::Value& member(const char* name) const;

  rapidjson::Document document_;
  Origin origin_;
};

// A line of a log that bears no case: head, cause, diagnosis or summary.
inline bool is_about_the_run(const ObjectReader& line) {
  return line.has("groundtruth") || line.has("cause") || line.has("diagnosis") || line.has("summary");
}

// A JSON string that says this.
std::string quoted(std::string_view text);

}  // namespace groundtruth::validation
