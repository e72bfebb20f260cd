// RapidCheck's own default of 100 cases a law is too few here. RC_PARAMS in the environment overrides this,
// for instance to replay a seed, or to let it search for longer.

#include <cstdlib>

#include <gtest/gtest.h>

namespace {

class MoreCases : public ::testing::Environment {
 public:
  void SetUp() override { setenv("RC_PARAMS", "max_success=300", 0); }
};

const auto* const more_cases = ::testing::AddGlobalTestEnvironment(new MoreCases);

}  // namespace
