#include <groundtruth/validation/case_name.hpp>

#include <array>
#include <charconv>
#include <regex>

#include <fmt/format.h>

namespace groundtruth::validation {
namespace {

constexpr std::array<std::string_view, number_of_kinds> kinds{"entry", "clip", "step"};

template <typename Number>
Number number_in(const std::string& digits) {
  Number number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace

std::string_view name_of(Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }

std::optional<Kind> kind_named(std::string_view name) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == name) return static_cast<Kind>(i);
  }
  return std::nullopt;
}

std::string write_case_name(const CaseName& name) {
  std::string text =
      fmt::format("{}:{}:{}:{}{}", name.seed, name.strand, name.batch, name_of(name.kind), name.number);
  for (const Change& change : name.changes) text += fmt::format("+{}.{}", change.of_scene, change.of_ask);
  return text;
}

std::optional<CaseName> read_case_name(std::string_view text) {
  static const std::regex form(
      "([0-9]{1,19}):([0-9]{1,19}):([0-9]{1,19}):(entry|clip|step)([0-9]{1,19})((?:\\+[0-9]{1,9}\\.[0-9]{1,9}"
      ")*)");
  static const std::regex one_change("\\+([0-9]+)\\.([0-9]+)");
  const std::string whole(text);
  std::smatch match;
  if (!std::regex_match(whole, match, form)) return std::nullopt;
  CaseName name{number_in<std::uint64_t>(match[1]), number_in<std::uint64_t>(match[2]),
                number_in<std::uint64_t>(match[3]), *kind_named(match[4].str()),
                number_in<std::uint64_t>(match[5]), {}};
  const std::string changes = match[6];
  for (std::sregex_iterator change(changes.begin(), changes.end(), one_change), end; change != end;
       ++change) {
    name.changes.push_back({number_in<std::uint32_t>((*change)[1]), number_in<std::uint32_t>((*change)[2])});
  }
  return name;
}

}  // namespace groundtruth::validation
