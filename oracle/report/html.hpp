#pragma once
// Bits of HTML that are XML as well. Private to this folder.

#include <string>
#include <vector>

#include <groundtruth/report/escaped.hpp>

namespace groundtruth::report {

enum class Align { words, numbers };

// With a heading row; cells are HTML already.
class HtmlTable {
 public:
  struct Column {
    std::string heading;  // text
    Align align = Align::numbers;
  };
  HtmlTable(std::string caption, std::vector<Column> columns);
  void add(const std::vector<std::string>& cells, const std::string& row_class = {});
  std::string finished() const;

 private:
  std::vector<Column> columns_;
  std::string html_;
};

// A number of ns, us, ms or s in three digits.
std::string duration_in_words(double nanoseconds);

// "0.5", "1.2e+03"; "0" for 0.
std::string short_number(double value);

// The style of the page, for light, dark and paper.
extern const char* const page_style;

}  // namespace groundtruth::report
