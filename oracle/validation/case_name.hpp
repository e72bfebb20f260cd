#pragma once
// Names of generated cases. A name says all that it takes to make the case again, whatever the implementation
// answered: SEED:STRAND:BATCH:KIND+NUMBER, and then +CHANGE for each change that was made to it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace groundtruth::validation {

enum class Kind { entry, clip, step };  // in the order of Ask
inline constexpr std::size_t number_of_kinds = 3;

std::string_view name_of(Kind kind);
std::optional<Kind> kind_named(std::string_view name);

// What one change does to scene and ask: 0 leaves it as it is.
struct Change {
  std::uint32_t of_scene = 0;
  std::uint32_t of_ask = 0;
  bool operator==(const Change&) const = default;
};

struct CaseName {
  std::uint64_t seed = 0;
  std::uint64_t strand = 0;
  std::uint64_t batch = 0;  // cases of a batch share a scene
  Kind kind = Kind::entry;
  std::uint64_t number = 0;
  std::vector<Change> changes;
  bool operator==(const CaseName&) const = default;
};

// "1:12:30:entry4", "1:12:30:entry4+0.17+3.5"
std::string write_case_name(const CaseName& name);
std::optional<CaseName> read_case_name(std::string_view text);

}  // namespace groundtruth::validation
