// RapidCheck's own default of 100 cases a law is too few here. RC_PARAMS in the environment overrides this,
// for instance to replay a seed, or to let it search for longer.

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace {

class MoreCases : public ::testing::Environment {
 public:
  void SetUp() override {
    const char* given = std::getenv("RC_PARAMS");
    const std::string params = std::string("max_success=300 ") + (given != nullptr ? given : "");
    setenv("RC_PARAMS", params.c_str(), 1);
  }
};

const auto* const more_cases = ::testing::AddGlobalTestEnvironment(new MoreCases);

}  // namespace
