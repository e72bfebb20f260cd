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

constexpr double panel_width = 380, panel_height = 150, gap_x = 60, gap_y = 62, margin = 60, top = 70;
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

void label_axes(const Grid& grid, const Panel& panel, Svg& svg) {
  const double below = panel.upper() + panel_height;
  for (double power = std::ceil(std::log10(grid.h_omegas.front()) - 1e-9);
       power <= std::log10(grid.h_omegas.back()) + 1e-9; ++power) {
    const double x = panel.x_of_value(std::pow(10, power));
    svg.polyline({{x, below}, {x, below + 4}});
    svg.text(x, below + 17, Anchor::middle, fmt::format("{:g}", std::pow(10, power)));
  }
  svg.text(panel.left() + panel_width / 2, below + 31, Anchor::middle, "h omega");
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
    svg.rectangle(x, 32, 14, 14, colours[i]);
    svg.text(x + 20, 44, Anchor::start, std::string(stability::name_of(static_cast<Fate>(i))));
    x += 130;
  }
  svg.polyline({{x, 39}, {x + 24, 39}});
  svg.text(x + 30, 44, Anchor::start, "2 (sqrt(1 + zeta^2) - zeta) of the fastest mode");
}

}  // namespace

std::string svg_of(const Grid& grid, const std::vector<Cell>& cells) {
  const std::size_t columns = grid.h_omegas.size(), rows = grid.damping_ratios.size();
  Svg svg(2 * margin + 3 * panel_width + 2 * gap_x, top + 4 * (panel_height + gap_y),
          "Maps of what became of parked machines: the numbers are those of groundtruth stability --csv");
  svg.text(margin, 20, Anchor::start,
           fmt::format("Parked on a slope of {:g} %: damping ratio (up) over h omega", 100 * grid.slope));
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
  return svg.finished();
}

}  // namespace groundtruth::report
