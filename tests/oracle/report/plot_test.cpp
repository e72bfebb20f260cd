#include <groundtruth/report/plot.hpp>

#include <gtest/gtest.h>

namespace groundtruth::report {
namespace {

TEST(Ticks, AreRoundNumbersWithinTheRange) {
  EXPECT_EQ(ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks(-1, 1, 4), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  EXPECT_EQ(ticks(1e9, 1e9 + 30, 3), (std::vector<double>{1e9, 1e9 + 10, 1e9 + 20, 1e9 + 30}));
  EXPECT_EQ(ticks(0.25, 0.26, 1), (std::vector<double>{0.25, 0.26}));
}

TEST(Svg, DrawsWhatItIsGivenAndEscapesText) {
  Figure figure{"a < b & c", "time", 0, 2, {{Wash::second, "slip"}}, {}};
  figure.panels.push_back({"speed", {{"v", Ink::second, {{0, 1}, {2, 1}}}}, {{0, 1, Wash::second}}});
  const std::string svg = svg_of(figure);
  EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_NE(svg.find("<path class=\"line ink1\" d=\"M80.00,119.00L840.00,119.00\"/>"), std::string::npos)
      << "a line that does not move lies in the middle";
  EXPECT_NE(svg.find("<rect class=\"wash1\" x=\"80.00\" y=\"64.0\" width=\"380.00\""), std::string::npos);
  EXPECT_NE(svg.find("prefers-color-scheme: dark"), std::string::npos);
}

}  // namespace
}  // namespace groundtruth::report
