#pragma once
// JSON text with doubles as SPEC section 8 wants them. Not installed.

#include <optional>
#include <string>

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <groundtruth/problem/vector.hpp>
#include <groundtruth/text/number_text.hpp>

namespace groundtruth {

class JsonWriter {
 public:
  std::string take() const { return {buffer_.GetString(), buffer_.GetSize()}; }

  void open_object() { writer_.StartObject(); }
  void close_object() { writer_.EndObject(); }
  void open_array() { writer_.StartArray(); }
  void close_array() { writer_.EndArray(); }
  void key(std::string_view name) { writer_.Key(name.data(), static_cast<rapidjson::SizeType>(name.size())); }
  void null() { writer_.Null(); }
  void text(std::string_view value) {
    writer_.String(value.data(), static_cast<rapidjson::SizeType>(value.size()));
  }
  void json(const std::string& value) {
    writer_.RawValue(value.data(), value.size(), rapidjson::kObjectType);
  }
  void count(std::size_t value) { writer_.Uint64(value); }
  void number(double value) { json(write_decimal(value)); }
  template <std::size_t size>
  void numbers(const std::array<double, size>& values) {
    open_array();
    for (const double value : values) number(value);
    close_array();
  }

  // A key and its value.
  void member(std::string_view name, std::string_view value) { key(name), text(value); }
  void member(std::string_view name, const char* value) { key(name), text(value); }
  void member(std::string_view name, double value) { key(name), number(value); }
  template <std::size_t size>
  void member(std::string_view name, const std::array<double, size>& values) {
    key(name), numbers(values);
  }
  void member(std::string_view name, const std::optional<double>& value) {
    key(name);
    value ? number(*value) : null();
  }

 private:
  rapidjson::StringBuffer buffer_;
  rapidjson::Writer<rapidjson::StringBuffer> writer_{buffer_};
};

}  // namespace groundtruth
