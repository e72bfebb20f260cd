#pragma once
// Pictures of rectangles, lines and words, as SVG. Private to this folder.

#include <string>
#include <utility>
#include <vector>

namespace groundtruth::report {

enum class Anchor { start, middle, end };

class Svg {
 public:
  Svg(double width, double height);

  void rectangle(double x, double y, double width, double height, const std::string& fill);
  void polyline(const std::vector<std::pair<double, double>>& points, const std::string& stroke);
  void text(double x, double y, Anchor anchor, const std::string& words);

  std::string finished() const;

 private:
  std::string body_;
};

}  // namespace groundtruth::report
