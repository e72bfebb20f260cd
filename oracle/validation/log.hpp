#pragma once
// The JSON Lines of a validation: a head, a record for each case that was not accepted, a summary at the end.

#include <optional>
#include <string>
#include <vector>

#include <groundtruth/validation/course.hpp>
#include <groundtruth/validation/record.hpp>

namespace groundtruth::validation {

struct Head {
  std::string subject;  // its name
  std::uint64_t seed = 1;
  std::uint64_t cases = 0;  // 0: no end
  Shard shard;
  std::string tolerance;  // in words
};

struct Summary {
  Tally tally;
  std::string ending;
  double seconds = 0;
};

std::string write_head(const Head& head);
std::string write_summary(const Summary& summary);

struct Log {
  std::string file;
  Head head;
  std::vector<Record> records;
  std::optional<Summary> summary;  // absent: it was cut off
};

// Throws BadInput. A last line that was cut off is passed over.
Log read_log(const std::string& file);

}  // namespace groundtruth::validation
