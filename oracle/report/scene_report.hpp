#pragma once
// What `groundtruth scene` shows.

#include <string>

#include <groundtruth/implementations/compilation.hpp>

namespace groundtruth::report {

struct CompiledScene {
  std::string name;
  implementations::Compilation compilation;
};

// A heading, and a row for each thing that was dropped, skipped or chosen.
std::string table_of(const CompiledScene& scene);

// The same as one line of JSON.
std::string json_of(const CompiledScene& scene);

}  // namespace groundtruth::report
