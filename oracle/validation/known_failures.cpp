#include <groundtruth/validation/known_failures.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include <groundtruth/validation/text_file.hpp>

#include "json_lines.hpp"

namespace groundtruth::validation {

KnownFailures::KnownFailures(std::vector<Record> failures) : failures_(std::move(failures)) {
  for (std::size_t i = 0; i < failures_.size(); ++i) places_.emplace(failures_[i].id, i);
}

const Record* KnownFailures::find(const std::string& id) const {
  const auto found = places_.find(id);
  return found == places_.end() ? nullptr : &failures_[found->second];
}

Expectation KnownFailures::expectation_of(const Record& failure) const {
  const Record* known = find(failure.id);
  if (known == nullptr) return Expectation::unexpected;
  const bool is_the_same = known->outcome == failure.outcome && known->difference == failure.difference;
  return is_the_same ? Expectation::known : Expectation::changed;
}

// The list is JSON Lines too: a head, and then a record a line.
KnownFailures read_known_failures(const std::string& file) {
  const std::vector<std::string> lines = read_text_lines(file);
  if (lines.empty()) throw BadInput(file, 1, "", "is empty: no list of known failures");
  const ObjectReader head(lines.front(), {file, 1});
  if (!head.has("groundtruth") || head.text("groundtruth") != "known-failures/1") {
    head.refuse("groundtruth", "is not known-failures/1");
  }
  std::vector<Record> failures;
  for (std::size_t i = 1; i < lines.size(); ++i) failures.push_back(read_record(lines[i], {file, i + 1}));
  return KnownFailures(std::move(failures));
}

void write_known_failures(const std::string& file, const std::vector<Record>& failures) {
  std::ofstream stream(file);
  stream << R"({"groundtruth":"known-failures/1"})" << '\n';
  for (Record failure : failures) {
    failure.expectation = Expectation::none;
    failure.seconds = 0;
    stream << write_record(failure) << '\n';
  }
  stream.flush();
  if (!stream) throw std::runtime_error(file + ": cannot be written: " + std::strerror(errno));
}

}  // namespace groundtruth::validation
