#include "failure_pages.hpp"

#include <set>

#include <fmt/format.h>

#include <groundtruth/validation/record.hpp>

namespace groundtruth::cli {
namespace {

using namespace validation;

page::Section section_of(const Failure& failure, const std::string& heading,
                         const std::string& replay_command) {
  page::Section section{explanation::explain(failure.asked), replay_command, heading, {}};
  const std::string& what = explanation_of(failure.finding);
  section.explanation.opinions.insert(section.explanation.opinions.begin(),
                                      {"yours", report::in_brief(record_of(failure).got),
                                       what.empty() ? std::string(name_of(failure.finding.outcome)) : what});
  section.remarks.push_back("Yours: " + what);
  return section;
}

page::Section section_of(const Cause& cause, const report::ReplayCommand& replay_command) {
  const diagnosis::Group& group = cause.group;
  const std::size_t count = group.members.size();
  const std::string heading =
      fmt::format("{} in {} ({} case{})", group.kind, group.signature, count, count == 1 ? "" : "s");
  return section_of(cause.smallest, heading, replay_command(group.representative.smallest.id));
}

}  // namespace

std::vector<page::Section> sections_of(const std::optional<Causes>& causes,
                                       const std::vector<Failure>& failures,
                                       const report::ReplayCommand& replay_command) {
  std::vector<page::Section> sections;
  if (causes) {
    for (const Cause& cause : causes->groups) sections.push_back(section_of(cause, replay_command));
    return sections;
  }
  std::set<std::string> seen;
  for (const Failure& failure : failures) {
    const Record record = record_of(failure);
    const std::string heading =
        fmt::format("{}: {} {}", name_of(record.kind), name_of(record.outcome), record.difference);
    if (seen.insert(heading).second)
      sections.push_back(section_of(failure, heading, replay_command(failure.asked.id)));
  }
  return sections;
}

std::string places_of(const std::vector<page::Section>& sections, const std::string& file) {
  std::string text = "\npages\n";
  for (std::size_t i = 0; i < sections.size(); ++i)
    text += fmt::format("  {}#case={}  {}\n", file, i + 1, sections[i].heading);
  return text;
}

}  // namespace groundtruth::cli
