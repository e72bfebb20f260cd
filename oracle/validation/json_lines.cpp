#include "json_lines.hpp"

namespace groundtruth::validation {

ObjectReader::ObjectReader(std::string_view text, const Origin& origin) : origin_(origin) {
  constexpr unsigned flags = rapidjson::kParseFullPrecisionFlag | rapidjson::kParseIterativeFlag;
  document_.Parse<flags>(text.data(), text.size());
  if (document_.HasParseError() || !document_.IsObject()) refuse("", "no JSON object");
}

std::string ObjectReader::text(const char* name) const {
  const rapidjson::Value& value = member(name);
  if (!value.IsString()) refuse(name, "no string");
  return {value.GetString(), value.GetStringLength()};
}

std::string ObjectReader::json(const char* name) const {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  member(name).Accept(writer);
  return {buffer.GetString(), buffer.GetSize()};
}

std::uint64_t ObjectReader::count(const char* name) const {
  const rapidjson::Value& value = member(name);
  if (!value.IsUint64()) refuse(name, "no count");
  return value.GetUint64();
}

double ObjectReader::number(const char* name) const {
  const rapidjson::Value& value = member(name);
  if (!value.IsNumber()) refuse(name, "no number");
  return value.GetDouble();
}

void ObjectReader::refuse(const std::string& field, const std::string& problem) const {
  throw BadInput(origin_.place, origin_.first_line, field, problem);
}

const rapidjson::Value& ObjectReader::member(const char* name) const {
  const auto found = document_.FindMember(name);
  if (found == document_.MemberEnd()) refuse(name, "is missing");
  return found->value;
}

std::string quoted(std::string_view text) {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
  return {buffer.GetString(), buffer.GetSize()};
}

}  // namespace groundtruth::validation
