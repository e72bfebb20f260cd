#include "markup.hpp"

#include <cmath>

#include <fmt/format.h>

namespace groundtruth::page {

Picture::Picture(double width, double height, const std::string& name, const std::string& description)
    : body_(fmt::format("<svg role=\"img\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" "
                        "aria-label=\"{2}. {3}\">\n<title>{2}</title><desc>{3}</desc>\n",
                        width, height, escaped(name), escaped(description))) {}

void Picture::polygon(const std::vector<Dot>& corners, const std::string& classes) {
  body_ += fmt::format("<polygon class=\"{}\" points=\"", classes);
  for (const Dot& corner : corners) body_ += fmt::format("{:.1f},{:.1f} ", corner.x, corner.y);
  body_ += "\"/>\n";
}

void Picture::line(Dot from, Dot to, const std::string& classes) {
  body_ += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
                       classes, from.x, from.y, to.x, to.y);
}

void Picture::arrow(Dot from, Dot to, const std::string& classes) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0.5)) return;
  const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  const double head = std::fmin(10, length);
  const Dot neck{to.x - head * ux, to.y - head * uy};
  line(from, neck, classes);
  polygon({to,
           {neck.x - 0.45 * head * uy, neck.y + 0.45 * head * ux},
           {neck.x + 0.45 * head * uy, neck.y - 0.45 * head * ux}},
          classes + " head");
}

void Picture::circle(Dot centre, double radius, const std::string& classes) {
  body_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", classes, centre.x,
                       centre.y, radius);
}

void Picture::rectangle(Dot corner, double width, double height, const std::string& classes) {
  body_ += fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                       classes, corner.x, corner.y, width, height);
}

void Picture::path(const std::string& d, const std::string& classes) {
  body_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", classes, d);
}

void Picture::text(Dot at, const std::string& anchor, const std::string& words, const std::string& classes) {
  body_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", classes,
                       at.x, at.y, anchor, escaped(words));
}

}  // namespace groundtruth::page
