#pragma once
// A place in a JSON document and the path that leads to it: what readers of scenes, asks and answers walk.
// Every refusal is a BadInput that names file, line and path.

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <groundtruth/problem/vector.hpp>
#include <groundtruth/text/json.hpp>

namespace groundtruth {

// A child keeps a pointer to its parent, which must outlive it.
class Field {
 public:
  Field(const Json& json, const Origin& origin) : json_(&json), origin_(&origin) {}

  [[noreturn]] void refuse(const std::string& problem) const;
  // refuse() with the value in front: "VALUE PROBLEM".
  [[noreturn]] void refuse_value(const std::string& problem) const;

  const Json& json() const { return *json_; }
  bool is_null() const { return std::holds_alternative<std::nullptr_t>(json_->value); }
  bool is_text() const { return std::holds_alternative<std::string>(json_->value); }

  double number() const;  // also from a hex float in a string
  double positive() const;
  double negative() const;
  double at_least_zero() const;
  double at_most_zero() const;
  Vector vector() const;
  const std::string& text() const;

  // Arrays.
  std::size_t size() const;
  Field operator[](std::size_t index) const;
  void require_size(std::size_t size) const;

  // Objects. Requires that only() was asked before.
  void only(std::initializer_list<std::string_view> keys) const;  // refuses others and repeated ones
  Field operator[](std::string_view key) const;                   // refuses if it is missing
  std::optional<Field> find(std::string_view key) const;
  const Json::Object& object() const;  // refuses repeated keys
  Field member(std::size_t index) const;

 private:
  Field(const Json& json, const Field& parent, std::string_view key, std::size_t index)
      : json_(&json), origin_(parent.origin_), parent_(&parent), key_(key), index_(index) {}
  std::string path() const;

  const Json* json_;
  const Origin* origin_;
  const Field* parent_ = nullptr;
  std::string_view key_;   // empty in an array
  std::size_t index_ = 0;  // in an array
};

}  // namespace groundtruth
