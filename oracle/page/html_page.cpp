#include <groundtruth/page/html_page.hpp>

#include <fmt/format.h>

#include "assets.hpp"
#include "html_section.hpp"
#include "markup.hpp"

namespace groundtruth::page {
namespace {

std::string heading_of(const Section& section) {
  return section.heading.empty() ? section.explanation.asked.id : section.heading;
}

std::string contents_of(const std::vector<Section>& sections) {
  if (sections.size() == 1) return "";
  std::string list = "<nav aria-label=\"Cases\"><ol class=\"contents\">\n";
  for (std::size_t i = 0; i < sections.size(); ++i)
    list += fmt::format("<li><a href=\"#case={}\">{}</a></li>\n", i + 1, escaped(heading_of(sections[i])));
  return list + "</ol></nav>\n";
}

std::string steps_from(std::size_t number, std::size_t count) {
  if (count == 1) return "";
  std::string links = "<p class=\"steps\">";
  if (number > 1) links += fmt::format("<a class=\"previous\" href=\"#case={}\">← previous</a> ", number - 1);
  links += fmt::format("<span>{} of {}</span>", number, count);
  if (number < count) links += fmt::format(" <a class=\"next\" href=\"#case={}\">next →</a>", number + 1);
  return links + "</p>\n";
}

}  // namespace

std::string html_page(const std::vector<Section>& sections, const std::string& title) {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'\">\n<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>{0}</title>\n<style>\n{1}</style></head>\n<body>\n<header><h1>{0}</h1></header>\n",
      escaped(title), style_sheet);
  page += contents_of(sections) + "<main>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    page += fmt::format("<section class=\"case\" id=\"case={}\">\n<h2>{}</h2>\n", i + 1,
                        escaped(heading_of(sections[i])));
    page += steps_from(i + 1, sections.size());
    page += html_section(sections[i]) + "</section>\n";
  }
  return page + fmt::format("</main>\n<script>\n{}</script>\n</body></html>\n", script);
}

}  // namespace groundtruth::page
