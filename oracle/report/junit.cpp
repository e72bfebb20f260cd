#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <groundtruth/report/escaped.hpp>
#include <groundtruth/report/validation_report.hpp>

namespace groundtruth::report {
namespace {

using namespace validation;

// XML 1.0 has no way to say most control characters.
std::string in_xml(std::string_view text) {
  std::string sayable(text);
  std::replace_if(
      sayable.begin(), sayable.end(), [](unsigned char c) { return c < 0x20; }, '?');
  return escaped(sayable);
}

std::string test_of(const Record& record) {
  const bool is_known = record.expectation == Expectation::known;
  const bool is_wrong = record.outcome == Outcome::wrong || record.outcome == Outcome::accepted;
  std::string text = fmt::format("    <testcase classname=\"groundtruth.{}\" name=\"{}\" time=\"{:.6f}\">\n",
                                 name_of(record.kind), in_xml(record.id), record.seconds);
  if (is_known) {
    text += fmt::format("      <skipped message=\"known to fail: {}\"/>\n", in_xml(record.explanation));
  } else {
    const std::string_view element = is_wrong ? "failure" : "error";
    text += fmt::format("      <{} type=\"{} {}\" message=\"{}\">{}\n{}\n{}\n{}</{}>\n", element,
                        name_of(record.outcome), record.difference, in_xml(record.explanation),
                        in_xml(record.scene), in_xml(record.ask), in_xml(record.got), in_xml(record.exact),
                        element);
  }
  return text + "    </testcase>\n";
}

std::string suite_of(const Tally& tally, const std::vector<Record>& records, Kind kind) {
  std::string tests;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t known = 0;
  for (const Record& record : records) {
    if (record.kind != kind) continue;
    tests += test_of(record);
    const bool is_wrong = record.outcome == Outcome::wrong || record.outcome == Outcome::accepted;
    (record.expectation == Expectation::known ? known : is_wrong ? failures : errors) += 1;
  }
  const std::uint64_t accepted = tally.count(kind, Outcome::accepted);
  if (accepted > 0) {
    tests += fmt::format("    <testcase classname=\"groundtruth.{}\" name=\"{} asks accepted\"/>\n",
                         name_of(kind), accepted);
  }
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}  "
      "</testsuite>\n",
      name_of(kind), failures + errors + known + (accepted > 0 ? 1 : 0), failures, errors, known, tests);
}

}  // namespace

std::string junit_of(const Tally& tally, const std::vector<Record>& records) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"groundtruth validate\">\n";
  for (const Kind kind : {Kind::entry, Kind::clip, Kind::step}) text += suite_of(tally, records, kind);
  return text + "</testsuites>\n";
}

}  // namespace groundtruth::report
