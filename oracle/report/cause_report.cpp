#include <groundtruth/report/cause_report.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace groundtruth::report {
namespace {

using namespace validation;

std::string in_words(const diagnosis::Size& size) {
  return fmt::format("{} half-space{}, numbers of weight {:.0f}", size.leaves, size.leaves == 1 ? "" : "s",
                     size.numbers);
}

std::string paragraph_of(const Cause& cause, const ReplayCommand& replay_command) {
  const diagnosis::Shrunk& shrunk = cause.group.representative;
  const Record record = record_of(cause.smallest);
  const std::size_t count = cause.group.members.size();
  std::string text = fmt::format("\n{} in {} ({} case{})\n", cause.group.kind, cause.group.signature, count,
                                 count == 1 ? "" : "s");
  text += fmt::format("  from {} to {}{}\n", in_words(shrunk.before), in_words(shrunk.after),
                      shrunk.is_minimum ? "; nothing simpler fails like this" : "");
  if (!record.explanation.empty()) text += fmt::format("  {}\n", record.explanation);
  if (record.scene != "null" && !record.scene.empty())
    text += fmt::format("  scene  {}\n", in_brief(record.scene));
  text +=
      fmt::format("  ask    {}\n  got    {}\n  exact  {}\n", record.ask, in_brief(record.got), record.exact);
  if (!cause.group.does_not_matter.empty())
    text += fmt::format("  does not matter: {}\n", fmt::join(cause.group.does_not_matter, ", "));
  return text + fmt::format("  replay {}\n", replay_command(shrunk.smallest.id));
}

std::string verdict_of(const std::optional<diagnosis::Diagnosis>& diagnosis) {
  if (!diagnosis) return "\ndiagnosis: none of the known errors explains this\n";
  std::string text =
      fmt::format("\ndiagnosis: {}: {}\n  explains {} of {} failures, contradicts {} of {} right answers\n",
                  diagnosis->name, diagnosis->explanation, diagnosis->explained, diagnosis->failures,
                  diagnosis->contradicted, diagnosis->accepted);
  if (!diagnosis->equals.empty()) text += fmt::format("  so do: {}\n", fmt::join(diagnosis->equals, "; "));
  return text;
}

}  // namespace

std::string causes_of(const Causes& causes, const ReplayCommand& replay_command) {
  std::string text;
  for (const Cause& cause : causes.groups) text += paragraph_of(cause, replay_command);
  return text + verdict_of(causes.diagnosis);
}

}  // namespace groundtruth::report
