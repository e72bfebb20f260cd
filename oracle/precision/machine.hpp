#pragma once
// What figures were taken with.

#include <string>

namespace groundtruth::precision {

struct Machine {
  std::string processor;  // as the system names it, or "unknown"
  std::string compiler;
  std::string flags;
  std::string commit;  // of the sources when the build was configured; "unknown" outside a checkout
};

Machine this_machine();

}  // namespace groundtruth::precision
