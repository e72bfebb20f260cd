#include <groundtruth/report/stability_report.hpp>

#include <algorithm>
#include <regex>
#include <string>

#include <gtest/gtest.h>

namespace groundtruth::report {
namespace {

using stability::Cell;
using stability::Fate;
using stability::Grid;

const Grid grid{{0.1, 1, 10, 100, 1000}, {0, 1}, 0.05, 3000};

// Of every integrator, number of wheels and relocation, each fate somewhere.
std::vector<Cell> all_cells() {
  std::vector<Cell> cells;
  for (const auto integrator :
       {rig::Integrator::semi_implicit, rig::Integrator::half_kick, rig::Integrator::implicit})
    for (const auto wheels : {stability::Wheels::one, stability::Wheels::three})
      for (const auto relocation : {Relocation::spring, Relocation::return_mapping})
        for (const double damping : grid.damping_ratios)
          for (const double h_omega : grid.h_omegas) {
            Cell cell;
            cell.parked = {wheels, h_omega, damping, grid.slope, integrator, relocation};
            cell.fate = static_cast<Fate>(cells.size() % 6);
            cells.push_back(cell);
          }
  return cells;
}

int count_of(const std::string& word, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

std::size_t letters_of(const std::string& utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

TEST(StabilityMap, NamesEveryFateAndPanelAndAllPowersOfTen) {
  const std::string svg = svg_of(grid, all_cells());
  for (int fate = 0; fate < 6; ++fate)
    EXPECT_NE(svg.find(stability::name_of(static_cast<Fate>(fate))), std::string::npos) << fate;
  EXPECT_EQ(count_of("3 wheels, return-mapping<", svg), 3);
  for (const char* power : {">0.1<", ">1<", ">10<", ">10²<", ">10³<"})
    EXPECT_GE(count_of(power, svg), 12) << power;
}

// Besides the ticks, five a panel, and the legend's.
TEST(StabilityMap, DrawsTheLimitOfExplicitIntegratorsOnly) {
  EXPECT_EQ(count_of("<polyline", svg_of(grid, all_cells())), 12 * 5 + 1 + 8);
}

TEST(StabilityMap, CutsNoWordsAtItsRightEdge) {
  const std::string svg = svg_of(grid, all_cells());
  const std::regex text("<text [^>]*x=\"([0-9.]+)\"[^>]*text-anchor=\"start\">([^<]*)<");
  const double width = std::stod(svg.substr(svg.find("width=\"") + 7));
  constexpr double letter = 7.5;  // px, on average, of 14 px letters
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it)
    EXPECT_LT(std::stod((*it)[1]) + letter * static_cast<double>(letters_of((*it)[2])), width) << (*it)[2];
}

}  // namespace
}  // namespace groundtruth::report
