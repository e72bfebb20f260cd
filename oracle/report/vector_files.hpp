#pragma once
// Frozen vectors, for those who run no program of ours: asks, exact answers and what each is for.

#include <string>
#include <vector>

#include <groundtruth/cases/case.hpp>

namespace groundtruth::report {

struct VectorFile {
  std::string name;
  std::string text;
};

// asks.jsonl, answers.jsonl (of the exact engine, with every admissible face), cases.json (id, flags, note),
// schema.json (JSON Schema 2020-12 of a line of asks and of a line of answers) and README.txt. The same cases
// give the same bytes.
std::vector<VectorFile> vector_files(const std::vector<cases::Case>& cases);

}  // namespace groundtruth::report
