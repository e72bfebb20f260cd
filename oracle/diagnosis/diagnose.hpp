#pragma once
// Which known error explains an implementation's answers?

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <groundtruth/cases/case.hpp>
#include <groundtruth/problem/answer.hpp>

namespace groundtruth::diagnosis {

// What an implementation said, and what is true.
struct Witness {
  cases::Case asked;
  Answer got;
  Answer exact;
};

struct Diagnosis {
  std::string name;              // of an erratum of SPEC section 7, of two of them, or of a classic slip
  std::string explanation;       // one line
  std::size_t explained = 0;     // of the failures: it answers like the implementation
  std::size_t failures = 0;      // that it was tried on
  std::size_t contradicted = 0;  // of the accepted answers: it answers otherwise
  std::size_t accepted = 0;
  std::vector<std::string> equals;  // others of as few errors that do as well: nothing asked tells them apart
};

// The error that explains most and contradicts least: single errata and slips first, pairs of errata if none
// of these explains everything. Nothing unless it explains at least nine of ten failures, and contradicts at
// most one in fifty of the accepted answers. Looks at a bounded number of witnesses, taken in turns from each
// kind of ask and of difference; those with small scenes first.
std::optional<Diagnosis> diagnose(std::span<const Witness> failures, std::span<const Witness> accepted);

}  // namespace groundtruth::diagnosis
