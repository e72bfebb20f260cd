#pragma once
// The ground on which a page's charts are drawn: axes with logarithmic ticks, marks with labels that keep out
// of each other's way, and colours that follow the reader's choice of light or dark. Private to this folder.

#include <string>
#include <utility>
#include <vector>

namespace groundtruth::report {

// Classes of chart_style: c0 (ours) is the accent, the others are told apart by hue and by mark.
enum class Hue { ours, engines, machine, software, lazy };

enum class Mark { disc, ring, cross, square, diamond };

struct Place {
  double x = 0, y = 0;
};

class Chart {
 public:
  // `title` and `description` are read out by those who do not see.
  Chart(double width, double height, const std::string& title, const std::string& description);

  void frame(double x, double y, double width, double height);
  void grid(Place from, Place to);
  void line(const std::vector<Place>& points, const std::string& css_class);
  void mark(Mark mark, Hue hue, Place at);
  void text(Place at, const std::string& anchor, const std::string& words, const std::string& css_class = {});
  void turned_text(Place at, const std::string& words);
  // Beside the mark, where nothing written so far is in the way.
  void label(Place at, Hue hue, const std::string& words);
  // Labels keep out of here.
  void occupy(double x, double y, double width, double height);

  std::string finished() const { return svg_ + "</svg>\n"; }

 private:
  struct Box {
    double x, y, width, height;
  };
  bool is_free(const Box& box) const;

  double width_;
  std::string svg_;
  std::vector<Box> taken_;
};

// "10", "1000", "1e6": of 10^exponent.
std::string power_of_ten(int exponent);

}  // namespace groundtruth::report
