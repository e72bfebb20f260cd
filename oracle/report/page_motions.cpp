#include <groundtruth/report/page_sections.hpp>

#include <fmt/format.h>

#include <groundtruth/report/html.hpp>
#include <groundtruth/report/stability_report.hpp>
#include <groundtruth/report/trajectory_errors_plot.hpp>

namespace groundtruth::report {

std::string left_out_section(const Measured& measured) {
  HtmlTable table(
      "Time per ordinary entry ask, with and without; a factor above 1 is what leaving out is worth.",
      {{"scene", Align::words},
       {"left out", Align::words},
       {"how many"},
       {"with"},
       {"without"},
       {"factor"},
       {"same answers", Align::words},
       {"why", Align::words}});
  for (const precision::LeftOutWorth& worth : measured.left_out) {
    const bool is_all = worth.what == "all";
    table.add({escaped(worth.scene), is_all ? "<strong>all together</strong>" : escaped(worth.what),
               is_all ? "" : std::to_string(worth.count), duration_in_words(worth.with_ns.median),
               duration_in_words(worth.without_ns.median),
               fmt::format("{:.2f}", worth.without_ns.median / worth.with_ns.median),
               worth.same_answers ? "<span class=\"good\">yes</span>" : "<span class=\"bad\">NO</span>",
               is_all ? "" : escaped(worth.why)});
  }
  return table.finished() + "<p class=\"soft\">" + escaped(provenance_of(measured)) + "</p>\n";
}

std::string trajectory_section(const Measured& measured) {
  std::string html;
  for (const precision::MotionKind& kind : precision::motion_kinds()) {
    html += fmt::format("<h3>{}</h3>\n<figure>\n", escaped(kind.name));
    html += trajectory_errors_plot(kind.name, measured.trajectories);
    html += fmt::format(
        "<figcaption>{}. Error: how far the body ends from where {} ends. Each curve halves its step from "
        "mark "
        "to mark, from 1/64 s on. Spring relocation is the model as asked for, and need not come to the same "
        "end "
        "however short its steps. {}</figcaption></figure>\n",
        escaped(kind.description), escaped(kind.reference), escaped(provenance_of(measured)));
  }
  return html;
}

std::string stability_section(const Measured& measured) {
  std::string html = "<figure class=\"map\">\n" + svg_of(measured.grid, measured.cells);
  html += fmt::format(
      "<figcaption>Parked machines on a slope of {:g} %, {} steps each: what became of them, over how stiff "
      "they are "
      "in steps (right) and how damped (up). The stepped line is where theory ends explicit integrators. {}"
      "</figcaption></figure>\n",
      100 * measured.grid.slope, measured.grid.steps, escaped(provenance_of(measured)));
  return html;
}

std::string omission_section(const Measured& measured) {
  HtmlTable table("What was not run, or failed.", {{"what", Align::words}, {"why", Align::words}});
  for (const Omission& omission : measured.omissions)
    table.add({escaped(omission.what), escaped(omission.why)});
  return table.finished();
}

}  // namespace groundtruth::report
