#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <groundtruth/report/stability_names.hpp>
#include <groundtruth/report/stability_report.hpp>
#include <groundtruth/report/svg.hpp>

namespace groundtruth::report {
namespace {

using stability::Cell;
using stability::Fate;
using stability::Grid;

constexpr double panel_width = 380, panel_height = 150, gap_x = 60, gap_y = 64, margin = 60, top = 112,
                 bottom = 76;
constexpr std::array<const char*, 6> colours{"#2a9d5c", "#a8dbb8", "#f2c14e",
                                             "#e8743b", "#8c1c2e", "#8d99ae"};

// Between the squares of a panel: h omega to the right, logarithmic; damping up, a row a ratio.
class Panel {
 public:
  Panel(const Grid& grid, std::size_t number)
      : grid_(grid),
        left_(margin + static_cast<double>(number / 4) * (panel_width + gap_x)),
        upper_(top + static_cast<double>(number % 4) * (panel_height + gap_y)) {}

  double left() const { return left_; }
  double upper() const { return upper_; }
  double width() const { return panel_width / static_cast<double>(grid_.h_omegas.size()); }
  double height() const { return panel_height / static_cast<double>(grid_.damping_ratios.size()); }
  double x_of(std::size_t column) const { return left_ + static_cast<double>(column) * width(); }
  double y_of(std::size_t row) const {
    return upper_ + panel_height - static_cast<double>(row + 1) * height();
  }
  // The middle of the column that this value has, or would have.
  double x_of_value(double h_omega) const {
    const double first = std::log(grid_.h_omegas.front()), last = std::log(grid_.h_omegas.back());
    const double columns = static_cast<double>(grid_.h_omegas.size() - 1);
    return left_ + ((std::log(h_omega) - first) / (last - first) * columns + 0.5) * width();
  }

 private:
  const Grid& grid_;
  double left_, upper_;
};

// 0.01, 0.1, 1, 10, then 10² and so on: side by side, long numbers would run into each other.
std::string power_of_ten(int exponent) {
  constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent < 2 || exponent > 9) return fmt::format("{:g}", std::pow(10, exponent));
  return fmt::format("10{}", digits[static_cast<std::size_t>(exponent)]);
}

void label_axes(const Grid& grid, const Panel& panel, Svg& svg) {
  const double below = panel.upper() + panel_height;
  const int first = static_cast<int>(std::ceil(std::log10(grid.h_omegas.front()) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(grid.h_omegas.back()) + 1e-9));
  for (int exponent = first; exponent <= last; ++exponent) {
    const double x = panel.x_of_value(std::pow(10, exponent));
    svg.polyline({{x, below}, {x, below + 4}});
    svg.text(x, below + 17, Anchor::middle, power_of_ten(exponent));
  }
  svg.text(panel.left() + panel_width, below + 33, Anchor::end, "hω →");
  svg.text(panel.left() - 6, panel.upper() - 8, Anchor::end, "ζ ↑");
  for (std::size_t row = 0; row < grid.damping_ratios.size(); ++row)
    svg.text(panel.left() - 6, panel.y_of(row) + panel.height() / 2 + 4, Anchor::end,
             fmt::format("{:g}", grid.damping_ratios[row]));
}

void draw_limit(const Grid& grid, const Panel& panel, stability::Wheels wheels, Svg& svg) {
  std::vector<std::pair<double, double>> line;
  for (std::size_t row = 0; row < grid.damping_ratios.size(); ++row) {
    const double x = panel.x_of_value(stability::explicit_limit(wheels, grid.damping_ratios[row]));
    line.emplace_back(x, panel.y_of(row) + panel.height());
    line.emplace_back(x, panel.y_of(row));
  }
  svg.polyline(line);
}

// Neighbours of one fate are one rectangle.
void draw_row(const std::vector<Cell>& cells, std::size_t first, std::size_t columns, std::size_t row,
              const Panel& panel, Svg& svg) {
  std::size_t from = 0;
  for (std::size_t to = 1; to <= columns; ++to) {
    const Fate fate = cells[first + from].fate;
    if (to < columns && cells[first + to].fate == fate) continue;
    svg.rectangle(panel.x_of(from), panel.y_of(row), panel.x_of(to) - panel.x_of(from), panel.height() - 0.5,
                  colours[static_cast<std::size_t>(fate)]);
    from = to;
  }
}

void draw_legend(Svg& svg) {
  double x = margin;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    svg.rectangle(x, 60, 14, 14, colours[i]);
    svg.text(x + 20, 72, Anchor::start, std::string(stability::name_of(static_cast<Fate>(i))));
    x += 125;
  }
  svg.polyline({{x + 10, 67}, {x + 34, 67}});
  svg.text(x + 40, 72, Anchor::start, "explicit limit by theory, hω = 2 (√(1 + z²) − z) / ρ");
}

void explain_above(const Grid& grid, Svg& svg) {
  svg.text(
      margin, 20, Anchor::start,
      fmt::format("A braked machine of 1,200 kg parked on a slope of {:g} %, {} steps: what became of it, "
                  "for each integrator, number of wheels and relocation",
                  100 * grid.slope, grid.steps));
  svg.text(margin, 40, Anchor::start,
           "hω: a step's length times √(sum of k / mass), the stiffness in steps. ζ: damping ratio, d / (2 "
           "√(k m)). "
           "Up to hω = 1/3, ω = 20 rad/s; from there on, h = 1/60 s.");
}

void explain_below(double y, Svg& svg) {
  svg.text(margin, y, Anchor::start,
           "settled: no pebble moves by a bit, the body is at rest or slows down. swinging: the body does "
           "not slow "
           "down. creeping: pebbles move. chattering: wheels leave the ground.");
  svg.text(
      margin, y + 20, Anchor::start,
      "blown up: energy rose by 0.1 m g · 1 m. gave a reason: a step said that it cannot be done. ρω: the "
      "fastest mode (1 wheel: ρ = 1), z = ρζ its damping.");
  svg.text(
      margin, y + 40, Anchor::start,
      "The implicit integrator has no limit by theory; from hω of about 10⁴ on, dampers turn the rounding of "
      "coordinates into more force than the machine's weight.");
}

}  // namespace

std::string svg_of(const Grid& grid, const std::vector<Cell>& cells) {
  const std::size_t columns = grid.h_omegas.size(), rows = grid.damping_ratios.size();
  const double height = top + 4 * (panel_height + gap_y) + bottom;
  Svg svg(2 * margin + 3 * panel_width + 2 * gap_x, height,
          "Maps of what became of parked machines: the numbers are those of groundtruth stability --csv");
  explain_above(grid, svg);
  draw_legend(svg);
  for (std::size_t number = 0; number * columns * rows < cells.size(); ++number) {
    const Panel panel(grid, number);
    const std::size_t first = number * columns * rows;
    for (std::size_t row = 0; row < rows; ++row)
      draw_row(cells, first + row * columns, columns, row, panel, svg);
    const stability::Parked& parked = cells[first].parked;
    svg.text(panel.left(), panel.upper() - 8, Anchor::start, panel_name(parked));
    label_axes(grid, panel, svg);
    if (parked.integrator != rig::Integrator::implicit) draw_limit(grid, panel, parked.wheels, svg);
  }
  explain_below(height - bottom + 16, svg);
  return svg.finished();
}

}  // namespace groundtruth::report
