#pragma once
// Small pieces of HTML and SVG. Private to this folder. Colours are classes, which page.css gives a light and
// a dark value.

#include <string>
#include <utility>
#include <vector>

#include <groundtruth/report/escaped.hpp>

namespace groundtruth::page {

using report::escaped;

struct Dot {
  double x = 0;
  double y = 0;
};

// A picture in pixels, y downwards, with a name and a description for those who cannot see it.
class Picture {
 public:
  Picture(double width, double height, const std::string& name, const std::string& description);

  void open_group(const std::string& attributes) { body_ += "<g " + attributes + ">\n"; }
  void close_group() { body_ += "</g>\n"; }
  void polygon(const std::vector<Dot>& corners, const std::string& classes);
  void line(Dot from, Dot to, const std::string& classes);
  void arrow(Dot from, Dot to, const std::string& classes);  // nothing if it has no length
  void circle(Dot centre, double radius, const std::string& classes);
  void rectangle(Dot corner, double width, double height, const std::string& classes);
  void path(const std::string& d, const std::string& classes);
  void text(Dot at, const std::string& anchor, const std::string& words, const std::string& classes = "");

  std::string finished() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace groundtruth::page
