#include <gtest/gtest.h>

#include <groundtruth/validation/case_name.hpp>

namespace groundtruth::validation {
namespace {

TEST(CaseName, ReadsBackAsWritten) {
  const CaseName name{18446744073709551ULL, 3, 20, Kind::step, 11, {{0, 17}, {999999, 0}}};
  EXPECT_EQ(write_case_name(name), "18446744073709551:3:20:step11+0.17+999999.0");
  EXPECT_EQ(read_case_name(write_case_name(name)), name);
  EXPECT_EQ(read_case_name("1:0:0:entry0"), (CaseName{1, 0, 0, Kind::entry, 0, {}}));
}

TEST(CaseName, IsNoneOfTheTextsThatOnlyLookLikeOne) {
  for (const char* text : {"", "1:2:3", "1:2:3:entry", "1:2:3:fly4", "1:2:3:entry4+", "1:2:3:entry4+1",
                           "1:2:3:entry4+1.2.3", "-1:2:3:entry4", "seam/along-the-top", "1:2:3:entry4 "}) {
    EXPECT_FALSE(read_case_name(text)) << text;
  }
}

}  // namespace
}  // namespace groundtruth::validation
