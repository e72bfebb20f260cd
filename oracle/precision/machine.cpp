#include <groundtruth/precision/machine.hpp>

#include <fstream>

namespace groundtruth::precision {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

Machine this_machine() {
#ifdef __clang__
  const std::string compiler = __VERSION__;
#else
  const std::string compiler = std::string("g++ ") + __VERSION__;
#endif
  return {processor(), compiler, GROUNDTRUTH_FLAGS, GROUNDTRUTH_COMMIT};
}

}  // namespace groundtruth::precision
