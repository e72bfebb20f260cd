#pragma once
// Pictures of rectangles, lines and words, as SVG; they follow the reader's choice of light or dark. Private
// to this folder.

#include <string>
#include <utility>
#include <vector>

namespace groundtruth::report {

enum class Anchor { start, middle, end };

class Svg {
 public:
  // `title` is read out by those who do not see.
  Svg(double width, double height, const std::string& title);

  void rectangle(double x, double y, double width, double height, const std::string& fill);
  void polyline(const std::vector<std::pair<double, double>>& points);
  void text(double x, double y, Anchor anchor, const std::string& words);

  std::string finished() const;

 private:
  std::string body_;
};

}  // namespace groundtruth::report
