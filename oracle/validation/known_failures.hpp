#pragma once
// Failures that are known and expected, so that a validation in CI tells what is new. The list cannot go
// stale: its cases are asked in every run, and one that passes, or fails in another way, is a failure too.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <groundtruth/validation/record.hpp>

namespace groundtruth::validation {

class KnownFailures {
 public:
  KnownFailures() = default;
  explicit KnownFailures(std::vector<Record> failures);

  const std::vector<Record>& failures() const { return failures_; }

  // Null if none is called so.
  const Record* find(const std::string& id) const;

  // Of a failure: known, or changed if it is known to fail in another way, or unexpected.
  Expectation expectation_of(const Record& failure) const;

 private:
  std::vector<Record> failures_;
  std::map<std::string, std::size_t> places_;  // by id
};

// Throws BadInput if the file cannot be read or is no such list.
KnownFailures read_known_failures(const std::string& file);

// A failure a line, so that differences between lists read well. Throws if it cannot be written.
void write_known_failures(const std::string& file, const std::vector<Record>& failures);

}  // namespace groundtruth::validation
