#include <groundtruth/report/plot.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <groundtruth/report/escaped.hpp>

namespace groundtruth::report {
namespace {

constexpr double left = 80, top = 64, panel_height = 110, panel_gap = 34, right = 20, bottom = 44;
constexpr double width = left + plot_width + right;

constexpr const char* style = R"(<style>
text { font: 12px sans-serif; fill: #333 } .title { font-size: 15px } .small { font-size: 11px }
.page { fill: #fff } .frame { fill: none; stroke: #999 } .grid { stroke: #e4e4e4 }
.line { fill: none; stroke-width: 1.3; stroke-linejoin: round }
.ink0 { stroke: #0b62a4 } .ink1 { stroke: #c4501b } text.ink0 { stroke: none; fill: #0b62a4 }
text.ink1 { stroke: none; fill: #c4501b }
.wash0 { fill: #d5ecd9 } .wash1 { fill: #fbdcc4 }
@media (prefers-color-scheme: dark) {
text { fill: #ccc } .page { fill: #16191d } .frame { stroke: #666 } .grid { stroke: #2c3138 }
.ink0 { stroke: #6db3f2 } .ink1 { stroke: #f59a63 } text.ink0 { fill: #6db3f2 } text.ink1 { fill: #f59a63 }
.wash0 { fill: #1e3a28 } .wash1 { fill: #4a2d1a } }
</style>
)";

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

// With a margin; a line that does not move lies in the middle.
Range range_of(const Panel& panel) {
  Range range;
  for (const Line& line : panel.lines) {
    for (const auto& [x, y] : line.points) {
      range.low = std::min(range.low, y);
      range.high = std::max(range.high, y);
    }
  }
  if (!(range.low <= range.high)) return {0, 1};
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  double margin = 0.06 * (range.high - range.low);
  if (margin <= 1e-9 * size) margin = size > 0 ? 0.01 * size : 1;
  return {range.low - margin, range.high + margin};
}

class Drawing {
 public:
  explicit Drawing(const Figure& figure) : figure_(figure) {}

  std::string draw() {
    const double height =
        top + static_cast<double>(figure_.panels.size()) * (panel_height + panel_gap) - panel_gap + bottom;
    svg_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n",
        width, height);
    svg_ += style;
    svg_ += fmt::format("<rect class=\"page\" width=\"{}\" height=\"{}\"/>\n", width, height);
    text(left, 24, "title", "start", figure_.title);
    draw_key();
    double y = top;
    for (const Panel& panel : figure_.panels) {
      draw_panel(panel, y);
      y += panel_height + panel_gap;
    }
    draw_x_axis(y - panel_gap);
    return svg_ + "</svg>\n";
  }

 private:
  void text(double x, double y, const char* kind, const char* anchor, const std::string& what) {
    svg_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", kind,
                        x, y, anchor, escaped(what));
  }

  void draw_key() {
    double x = width - right;
    for (auto entry = figure_.key.rbegin(); entry != figure_.key.rend(); ++entry) {
      text(x, 24, "small", "end", entry->second);
      x -= 7 * static_cast<double>(entry->second.size()) + 18;
      rectangle(x, 14, 12, 12, entry->first);
      x -= 12;
    }
  }

  void rectangle(double x, double y, double w, double h, Wash wash) {
    svg_ +=
        fmt::format("<rect class=\"wash{}\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\"/>\n",
                    static_cast<int>(wash), x, y, w, h);
  }

  double x_of(double x) const {
    return left + plot_width * (x - figure_.x_from) / (figure_.x_to - figure_.x_from);
  }

  void draw_panel(const Panel& panel, double y) {
    const Range range = range_of(panel);
    const auto y_of = [&](double value) {
      return y + panel_height * (range.high - value) / (range.high - range.low);
    };
    for (const Band& band : panel.bands)
      rectangle(x_of(band.from), y, x_of(band.to) - x_of(band.from), panel_height, band.wash);
    for (const double tick : ticks(range.low, range.high, 4)) {
      svg_ += fmt::format("<path class=\"grid\" d=\"M{},{:.1f}h{}\"/>\n", left, y_of(tick), plot_width);
      text(left - 6, y_of(tick) + 4, "small", "end", fmt::format("{:.6g}", tick));
    }
    for (const double tick : ticks(figure_.x_from, figure_.x_to, 8))
      svg_ += fmt::format("<path class=\"grid\" d=\"M{:.1f},{:.1f}v{}\"/>\n", x_of(tick), y, panel_height);
    svg_ += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, y,
                        plot_width, panel_height);
    text(left, y - 6, "small", "start", panel.title);
    double label_x = left + plot_width;
    for (auto line = panel.lines.rbegin(); line != panel.lines.rend(); ++line) {
      draw_line(*line, y_of);
      const std::string kind = fmt::format("small ink{}", static_cast<int>(line->ink));
      text(label_x, y - 6, kind.c_str(), "end", line->label);
      label_x -= 7 * static_cast<double>(line->label.size()) + 14;
    }
  }

  template <class YOf>
  void draw_line(const Line& line, const YOf& y_of) {
    if (line.points.empty()) return;
    svg_ += fmt::format("<path class=\"line ink{}\" d=\"", static_cast<int>(line.ink));
    char command = 'M';
    for (const auto& [x, y] : line.points) {
      svg_ += fmt::format("{}{:.2f},{:.2f}", command, x_of(x), y_of(y));
      command = 'L';
    }
    svg_ += "\"/>\n";
  }

  void draw_x_axis(double y) {
    for (const double tick : ticks(figure_.x_from, figure_.x_to, 8))
      text(x_of(tick), y + 16, "small", "middle", fmt::format("{:.6g}", tick));
    text(left + plot_width / 2.0, y + 34, "small", "middle", figure_.x_title);
  }

  const Figure& figure_;
  std::string svg_;
};

}  // namespace

std::vector<double> ticks(double low, double high, int wanted) {
  const double apart = (high - low) / wanted;
  const double power = std::pow(10, std::floor(std::log10(apart)));
  const double mantissa = apart / power;
  const double step = power * (mantissa < 1.5 ? 1 : mantissa < 3.5 ? 2 : mantissa < 7.5 ? 5 : 10);
  std::vector<double> result;
  for (double i = std::ceil(low / step); i <= high / step && result.size() < 100; ++i)
    result.push_back(i == 0 ? 0 : i * step);
  return result;
}

std::string svg_of(const Figure& figure) { return Drawing(figure).draw(); }

}  // namespace groundtruth::report
