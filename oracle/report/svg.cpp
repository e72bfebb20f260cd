#include <groundtruth/report/svg.hpp>

#include <array>

#include <fmt/format.h>

#include <groundtruth/report/escaped.hpp>

namespace groundtruth::report {
namespace {

constexpr const char* style =
    "<style>.paper { fill: #fff } .pen { fill: none; stroke: #000; stroke-width: 2 } .plain { font: 14px "
    "sans-serif; "
    "fill: #222 } @media (prefers-color-scheme: dark) { .paper { fill: #14171a } .pen { stroke: #fff } "
    ".plain { fill: #d5d9dd } }</style>\n";

}  // namespace

Svg::Svg(double width, double height, const std::string& title)
    : body_(
          fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
                      "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"sans-serif\" font-size=\"14\" role=\"img\" "
                      "aria-label=\"{2}\">\n{3}<rect class=\"paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n",
                      width, height, escaped(title), style)) {}

void Svg::rectangle(double x, double y, double width, double height, const std::string& fill) {
  body_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                       x, y, width, height, fill);
}

void Svg::polyline(const std::vector<std::pair<double, double>>& points) {
  body_ += "<polyline class=\"pen\" points=\"";
  for (const auto& [x, y] : points) body_ += fmt::format("{:.2f},{:.2f} ", x, y);
  body_ += "\"/>\n";
}

void Svg::text(double x, double y, Anchor anchor, const std::string& words) {
  constexpr std::array<const char*, 3> names{"start", "middle", "end"};
  body_ += fmt::format("<text class=\"plain\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n", x, y,
                       names[static_cast<std::size_t>(anchor)], escaped(words));
}

std::string Svg::finished() const { return body_ + "</svg>\n"; }

}  // namespace groundtruth::report
