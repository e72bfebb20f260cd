#include <groundtruth/report/chart.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <groundtruth/report/html.hpp>

namespace groundtruth::report {
namespace {

constexpr const char* style = R"(<style>
text { font: 12px system-ui, sans-serif; fill: #333 } .head { font-weight: 600; font-size: 13px }
.small { font-size: 11px } .page { fill: #fff } .frame { fill: none; stroke: #8a9199 }
.grid { stroke: #e1e4e8; fill: none } .zone { fill: #fbeeec } .front { stroke: #0b5cad; stroke-width: 2; fill: none;
stroke-dasharray: 5 4; opacity: .75 } .lead { stroke: #8a9199; fill: none; stroke-width: .7 }
.order { stroke: #8a9199; stroke-dasharray: 2 3; fill: none } .run { fill: none; stroke-width: 1.4 }
.c0 { fill: #0b5cad; stroke: #0b5cad } .c1 { fill: #6a3d9a; stroke: #6a3d9a } .c2 { fill: #a34a00; stroke: #a34a00 }
.c3 { fill: #1b6e45; stroke: #1b6e45 } .c4 { fill: #8c1c5a; stroke: #8c1c5a }
text.c0, text.c1, text.c2, text.c3, text.c4 { stroke: none } text.c0 { font-weight: 700 }
.ring { fill: none; stroke-width: 2 } .cross { stroke-width: 2.4; fill: none } .run.c0, .run.c1, .run.c2, .run.c3,
.run.c4 { fill: none }
@media (prefers-color-scheme: dark) { text { fill: #d5d9dd } .page { fill: #14171a } .frame { stroke: #7b848d }
.grid { stroke: #2b3137 } .zone { fill: #301d1b } .front { stroke: #7fbaf5 } .lead, .order { stroke: #7b848d }
.c0 { fill: #7fbaf5; stroke: #7fbaf5 } .c1 { fill: #c3a2ea; stroke: #c3a2ea } .c2 { fill: #f3a35c; stroke: #f3a35c }
.c3 { fill: #7fcf9f; stroke: #7fcf9f } .c4 { fill: #f092c0; stroke: #f092c0 }
.ring, .cross, .run.c0, .run.c1, .run.c2, .run.c3, .run.c4 { fill: none } }
</style>
)";

}  // namespace

Chart::Chart(double width, double height, const std::string& title, const std::string& description)
    : width_(width) {
  svg_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" aria-label=\"{2}\">\n<title>{2}</title><desc>{3}</desc>\n{4}"
      "<rect class=\"page\" width=\"{0}\" height=\"{1}\"/>\n",
      width, height, escaped(title), escaped(description), style);
}

void Chart::frame(double x, double y, double width, double height) {
  svg_ +=
      fmt::format("<rect class=\"frame\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", x,
                  y, width, height);
}

void Chart::grid(Place from, Place to) {
  svg_ +=
      fmt::format("<path class=\"grid\" d=\"M{:.1f},{:.1f}L{:.1f},{:.1f}\"/>\n", from.x, from.y, to.x, to.y);
}

void Chart::line(const std::vector<Place>& points, const std::string& css_class) {
  if (points.size() < 2) return;
  svg_ += fmt::format("<path class=\"{}\" d=\"", css_class);
  for (std::size_t i = 0; i < points.size(); ++i)
    svg_ += fmt::format("{}{:.1f},{:.1f}", i == 0 ? 'M' : 'L', points[i].x, points[i].y);
  svg_ += "\"/>\n";
}

void Chart::mark(Mark mark, Hue hue, Place at) {
  const int c = static_cast<int>(hue);
  switch (mark) {
    case Mark::disc:
      svg_ += fmt::format("<circle class=\"c{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"/>\n", c, at.x, at.y);
      break;
    case Mark::ring:
      svg_ +=
          fmt::format("<circle class=\"c{} ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"/>\n", c, at.x, at.y);
      break;
    case Mark::cross:
      svg_ += fmt::format("<path class=\"c{} cross\" d=\"M{:.1f},{:.1f}l9,9m0,-9l-9,9\"/>\n", c, at.x - 4.5,
                          at.y - 4.5);
      break;
    case Mark::square:
      svg_ += fmt::format("<rect class=\"c{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"7\" height=\"7\"/>\n", c,
                          at.x - 3.5, at.y - 3.5);
      break;
    case Mark::diamond:
      svg_ += fmt::format("<path class=\"c{}\" d=\"M{:.1f},{:.1f}l5,5l-5,5l-5,-5z\"/>\n", c, at.x, at.y - 5);
      break;
  }
  occupy(at.x - 5, at.y - 5, 10, 10);
}

void Chart::text(Place at, const std::string& anchor, const std::string& words,
                 const std::string& css_class) {
  svg_ += fmt::format("<text{} x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n",
                      css_class.empty() ? "" : " class=\"" + css_class + "\"", at.x, at.y, anchor,
                      escaped(words));
}

void Chart::turned_text(Place at, const std::string& words) {
  svg_ += fmt::format(
      "<text class=\"small\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\" "
      "text-anchor=\"middle\">{}</text>\n",
      at.x, at.y, escaped(words));
}

void Chart::label(Place at, Hue hue, const std::string& words) {
  const double width = 6.6 * static_cast<double>(words.size()) + 4, height = 13;
  const std::string css = fmt::format("small c{}", static_cast<int>(hue));
  for (int ring = 0; ring < 12; ++ring)
    for (const int up : {1, -1})
      for (const bool right : {true, false}) {
        const double middle = at.y - up * 13.0 * ring;
        const double x = right ? at.x + 9 : at.x - 9 - width;
        if (x < 0 || x + width > width_ || !is_free({x, middle - height / 2, width, height})) continue;
        occupy(x, middle - height / 2, width, height);
        if (ring > 0) line({{at.x, at.y}, {right ? x : x + width, middle}}, "lead");
        text({right ? x : x + width, middle + 4}, right ? "start" : "end", words, css);
        return;
      }
  text({at.x + 9, at.y + 4}, "start", words, css);
}

void Chart::occupy(double x, double y, double width, double height) {
  taken_.push_back({x, y, width, height});
}

bool Chart::is_free(const Box& box) const {
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
    return box.x < other.x + other.width && other.x < box.x + box.width && box.y < other.y + other.height &&
           other.y < box.y + box.height;
  });
}

std::string power_of_ten(int exponent) {
  if (exponent >= 0 && exponent <= 3) return fmt::format("{:.0f}", std::pow(10, exponent));
  return exponent < 0 && exponent >= -2 ? fmt::format("{:g}", std::pow(10, exponent))
                                        : fmt::format("1e{}", exponent);
}

}  // namespace groundtruth::report
