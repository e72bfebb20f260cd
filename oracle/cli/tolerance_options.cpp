#include "tolerance_options.hpp"

#include <limits>
#include <vector>

#include <fmt/format.h>

namespace groundtruth::cli {
void add_tolerance_options(CLI::App& command, ToleranceOptions& options) {
  std::vector<std::string> names;
  for (const judge::Profile& profile : judge::profiles()) names.emplace_back(profile.name);
  const CLI::Range not_negative(0.0, std::numeric_limits<double>::max());
  command.add_option("--profile", options.profile, "How much an answer may be off")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  command.add_option("--tolerance", options.metres, "Metres by which every plane may be moved")
      ->check(not_negative);
  command.add_option("--ulps", options.ulps, "Units of the last place of lambda beyond that")
      ->check(not_negative);
  command.add_flag("--strict", options.strict, "Where faces meet, only the canonical one may be named");
}

judge::Tolerance tolerance_of(const ToleranceOptions& options) {
  judge::Tolerance tolerance = judge::find_profile(options.profile)->tolerance;
  if (options.metres) tolerance.metres = *options.metres;
  if (options.ulps) tolerance.lambda_ulps = *options.ulps;
  if (options.strict) tolerance.faces = judge::Faces::canonical;
  return tolerance;
}

std::string in_words(const ToleranceOptions& options) {
  const judge::Tolerance tolerance = tolerance_of(options);
  return fmt::format(
      "profile {}: {}\nplanes {} m, lambda {} ulps, normals {} rad, decisions {}, vectors {} of their scale; "
      "{}\n",
      options.profile, judge::find_profile(options.profile)->stands_for, tolerance.metres, tolerance.lambda_ulps,
      tolerance.normal_angle, tolerance.relative_decision, tolerance.relative_number,
      options.strict ? "the canonical face only" : "any admissible face");
}

}  // namespace groundtruth::cli
