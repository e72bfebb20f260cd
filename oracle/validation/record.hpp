#pragma once
// A case that was not accepted, as text: a line of the JSON Lines that a validation leaves behind, with
// all that it takes to ask it again.

#include <cstdint>
#include <string>
#include <string_view>

#include <groundtruth/text/bad_input.hpp>
#include <groundtruth/validation/run.hpp>

namespace groundtruth::validation {

// Held against a list of known failures.
enum class Expectation { none, known, changed, unexpected, passes };

std::string_view name_of(Expectation expectation);

struct Record {
  std::string id;
  std::uint64_t ask_number = 0;
  Kind kind = Kind::entry;
  Outcome outcome = Outcome::wrong;
  std::string difference;  // of judge::Difference; "none" where the outcome says it all
  Expectation expectation = Expectation::none;
  std::string scene;  // JSON, as `groundtruth answer` reads it
  std::string ask;    // the same; bears the id
  std::string got;    // the line that came, JSON; or a JSON string where it was none; null if nothing came
  std::string exact;  // the line that the exact engine answers
  std::string explanation;  // one line
  double seconds = 0;
};

Record record_of(const Failure& failure);

// One line of JSON, without line end.
std::string write_record(const Record& record);

// Throws BadInput.
Record read_record(std::string_view text, const Origin& origin);

// The case that was asked. Throws BadInput.
cases::Case case_of(const Record& record, const Origin& origin);

}  // namespace groundtruth::validation
