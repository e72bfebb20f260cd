#include <groundtruth/report/validation_report.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include <fmt/format.h>

namespace groundtruth::report {
namespace {

using namespace validation;

constexpr std::array kinds{Kind::entry, Kind::clip, Kind::step};

struct Group {
  const Record* simplest = nullptr;
  std::size_t size = 0;
};

// Short texts have few leaves and round numbers.
bool is_simpler(const Record& left, const Record& right) {
  const auto length = [](const Record& record) { return record.scene.size() + record.ask.size(); };
  return length(left) < length(right);
}

using Key = std::tuple<Expectation, Outcome, Kind, std::string>;

std::map<Key, Group> groups_of(const std::vector<Record>& records) {
  std::map<Key, Group> groups;
  for (const Record& record : records) {
    if (record.expectation == Expectation::known) continue;
    Group& group = groups[{record.expectation, record.outcome, record.kind, record.difference}];
    ++group.size;
    if (group.simplest == nullptr || is_simpler(record, *group.simplest)) group.simplest = &record;
  }
  return groups;
}

std::string title_of(const Record& record) {
  std::string title = fmt::format("{}: {}", name_of(record.kind), name_of(record.outcome));
  if (record.outcome == Outcome::wrong) title += " " + record.difference;
  if (record.expectation == Expectation::passes) title += ", known to fail";
  if (record.expectation == Expectation::changed) title += ", known to fail in another way";
  return title;
}

}  // namespace

std::string in_brief(const std::string& text) {
  constexpr std::size_t most = 600;
  return text.size() <= most ? text : fmt::format("{}... ({} bytes)", text.substr(0, most), text.size());
}

std::string table_of(const Tally& tally) {
  std::string table = fmt::format("{:<6} {:>10} {:>9} {:>9} {:>9} {:>9} {:>11} {:>9}\n", "ask", "judged",
                                  "accepted", "wrong", "crashed", "hung", "unreadable", "skipped");
  for (const Kind kind : kinds) {
    const auto count = [&](Outcome outcome) { return tally.count(kind, outcome); };
    table +=
        fmt::format("{:<6} {:>10} {:>9} {:>9} {:>9} {:>9} {:>11} {:>9}\n", name_of(kind), tally.judged(kind),
                    count(Outcome::accepted), count(Outcome::wrong), count(Outcome::crashed),
                    count(Outcome::hung), count(Outcome::unreadable), count(Outcome::skipped));
  }
  return table;
}

std::string failures_of(const std::vector<Record>& records, const ReplayCommand& replay_command) {
  std::string text;
  for (const auto& [key, group] : groups_of(records)) {
    const Record& record = *group.simplest;
    text += fmt::format("\n{} ({} case{}, the simplest):\n", title_of(record), group.size,
                        group.size == 1 ? "" : "s");
    if (!record.explanation.empty()) text += fmt::format("  {}\n", record.explanation);
    text += fmt::format("  scene  {}\n  ask    {}\n  got    {}\n  exact  {}\n  replay {}\n",
                        in_brief(record.scene), record.ask, in_brief(record.got), record.exact,
                        replay_command(record.id));
  }
  return text;
}

}  // namespace groundtruth::report
