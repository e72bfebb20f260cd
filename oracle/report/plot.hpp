#pragma once
// Figures as SVG: panels one above another that share the horizontal axis. They follow the reader's choice of
// light or dark.

#include <string>
#include <utility>
#include <vector>

namespace groundtruth::report {

// Which of the figure's colours.
enum class Ink { first, second };
enum class Wash { first, second };  // of the background

struct Line {
  std::string label;
  Ink ink = Ink::first;
  std::vector<std::pair<double, double>> points;  // x ascending
};

struct Band {
  double from = 0;  // x
  double to = 0;
  Wash wash = Wash::first;
};

struct Panel {
  std::string title;  // with the unit
  std::vector<Line> lines;
  std::vector<Band> bands;
};

struct Figure {
  std::string title;
  std::string x_title;
  double x_from = 0;
  double x_to = 1;
  std::vector<std::pair<Wash, std::string>> key;  // what the bands mean
  std::vector<Panel> panels;
};

// Width of the panels' inside, in the units in which lines are drawn: more points are not seen.
inline constexpr int plot_width = 760;

std::string svg_of(const Figure& figure);

// Round numbers (1, 2 or 5 times a power of ten apart) within [low, high], about `wanted` of them. Requires
// low < high, both finite.
std::vector<double> ticks(double low, double high, int wanted);

}  // namespace groundtruth::report
