#pragma once
// One explanation as HTML, without its heading. Private to this folder.

#include <groundtruth/page/html_page.hpp>

namespace groundtruth::page {

std::string html_section(const Section& section);

// The cut, the slider over the breakpoints, the expression and the faces.
std::string html_of_entry(const explanation::EntryFacts& facts, const Scene& scene, double lambda);

// <dl> of names and values.
std::string html_of_lines(const std::vector<std::pair<std::string, std::string>>& lines);

}  // namespace groundtruth::page
