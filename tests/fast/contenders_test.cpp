// A search's list of parts, beyond what it holds without allocating.

#include <groundtruth/fast/contenders.hpp>

#include <gtest/gtest.h>

namespace groundtruth::fast {
namespace {

TEST(Contenders, KeepTheirOrderHoweverMany) {
  Contenders contenders;
  EXPECT_TRUE(contenders.empty());
  for (Part part = 0; part < 1000; ++part) contenders.push_back({part, {0.5, 0.75, part}});
  ASSERT_EQ(contenders.size(), 1000u);
  for (Part part = 0; part < 1000; ++part) {
    EXPECT_EQ(contenders[part].part, part);
    EXPECT_EQ(contenders[part].meeting.sole_place, part);
  }
}

TEST(Contenders, KnowWhichPartsTheyHave) {
  Contenders contenders;
  for (Part part = 0; part < 200; ++part) contenders.push_back({2 * part, no_meeting});
  EXPECT_TRUE(contenders.has(398));
  EXPECT_FALSE(contenders.has(399));
  contenders.shrink(199);
  EXPECT_FALSE(contenders.has(398));
}

}  // namespace
}  // namespace groundtruth::fast
