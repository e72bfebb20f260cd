#include <groundtruth/text/field.hpp>

#include <algorithm>
#include <set>

namespace groundtruth {

std::string Field::path() const {
  if (parent_ == nullptr) return "";
  const std::string before = parent_->path();
  if (key_.empty()) return before + "[" + std::to_string(index_) + "]";
  return before.empty() ? std::string(key_) : before + "." + std::string(key_);
}

void Field::refuse(const std::string& problem) const {
  throw BadInput(origin_->place, json_->line, path(), problem);
}

void Field::refuse_value(const std::string& problem) const { refuse(describe(*json_) + " " + problem); }

double Field::number() const {
  if (const double* value = std::get_if<double>(&json_->value)) return *value;
  if (const auto* number = std::get_if<UnreadableNumber>(&json_->value)) refuse(number->problem);
  if (!is_text()) refuse_value("is not a number");
  const ReadNumber read = read_hex_float(text());
  if (const auto* number = std::get_if<UnreadableNumber>(&read)) refuse(number->problem);
  return std::get<double>(read);
}

double Field::positive() const {
  if (!(number() > 0)) refuse_value("is not > 0");
  return number();
}

double Field::negative() const {
  if (!(number() < 0)) refuse_value("is not < 0");
  return number();
}

double Field::at_least_zero() const {
  if (!(number() >= 0)) refuse_value("is not >= 0");
  return number();
}

double Field::at_most_zero() const {
  if (!(number() <= 0)) refuse_value("is not <= 0");
  return number();
}

Vector Field::vector() const {
  require_size(3);
  return {(*this)[0].number(), (*this)[1].number(), (*this)[2].number()};
}

const std::string& Field::text() const {
  if (!is_text()) refuse_value("is not a string");
  return std::get<std::string>(json_->value);
}

std::size_t Field::size() const {
  const auto* array = std::get_if<Json::Array>(&json_->value);
  if (array == nullptr) refuse_value("is not an array");
  return array->size();
}

void Field::require_size(std::size_t expected) const {
  if (size() != expected) refuse_value("is not an array of " + std::to_string(expected));
}

Field Field::operator[](std::size_t index) const {
  return {std::get<Json::Array>(json_->value)[index], *this, "", index};
}

const Json::Object& Field::object() const {
  const auto* object = std::get_if<Json::Object>(&json_->value);
  if (object == nullptr) refuse_value("is not an object");
  std::set<std::string_view> seen;
  for (const auto& [key, value] : *object) {
    if (!seen.insert(key).second) Field(value, *this, key, 0).refuse("the key stands here twice");
  }
  return *object;
}

Field Field::member(std::size_t index) const {
  const auto& [key, value] = std::get<Json::Object>(json_->value)[index];
  return {value, *this, key, 0};
}

void Field::only(std::initializer_list<std::string_view> keys) const {
  for (const auto& [key, value] : object()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      Field(value, *this, key, 0).refuse("unknown key");
    }
  }
}

Field Field::operator[](std::string_view key) const {
  const auto found = find(key);
  if (!found) refuse(std::string(key) + " is missing");
  return *found;
}

std::optional<Field> Field::find(std::string_view key) const {
  for (const auto& [name, value] : std::get<Json::Object>(json_->value)) {
    if (name == key) return Field(value, *this, name, 0);
  }
  return std::nullopt;
}

}  // namespace groundtruth
