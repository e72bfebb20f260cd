#include <groundtruth/report/page.hpp>

#include <fmt/format.h>

#include <groundtruth/report/html.hpp>
#include <groundtruth/report/page_sections.hpp>

namespace groundtruth::report {
namespace {

std::string facts_of(const Measured& measured) {
  std::string html = "<dl class=\"facts\">\n";
  const auto fact = [&html](const std::string& what, const std::string& value) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(value));
  };
  fact("processor", measured.machine.processor);
  fact("compiler", measured.machine.compiler);
  fact("flags", measured.machine.flags);
  fact("commit", measured.machine.commit);
  fact("seed", std::to_string(measured.seed));
  fact("extent", fmt::format("{}, measured in {:.0f} s on one thread", measured.extent, measured.seconds));
  return html + "</dl>\n";
}

constexpr const char* introduction =
    R"(<p>A wheel meets the ground where a segment first enters a solid. Floating
point answers that quickly and now and then wrongly; exact numbers answer it rightly and slowly. This page puts the
same asks to thirteen kinds of arithmetic and shows what each costs and what it gets wrong.</p>
<ul>
<li><strong>entry</strong>: where along a segment (λ) is the solid entered, and through which face?
<strong>clip</strong>: how much of a force can the contact bear? <strong>step</strong>: a wheel's next state.</li>
<li><strong>ordinary</strong> asks are segments, forces and wheels anywhere. <strong>hostile</strong> asks are made
to hit faces, edges, corners, seams and friction borders exactly or by one ulp, or have extreme numbers.</li>
<li>A <strong>wrong</strong> answer has another decision than the exact one: hit or miss, face, material, stick or
slip, outcome. These are counted for themselves. <strong>Errors</strong> are those of rightly decided answers, in
units of the last place (ulp) of the exact value, which was not rounded: the nearest double is at most 0.5 off, and
no double can be promised to be nearer. Of vectors, an ulp is that of the largest component.</li>
<li>Times are medians over rounds in which all tiers took turns on the same thread; they leave out start-up and the
preparation of scenes. Tiers too slow for all asks answer the first ones; the tables say how many.</li>
</ul>
)";

std::string contents_of(const Measured& measured) {
  std::string html = "<nav aria-label=\"Contents\"><ul>\n";
  const auto entry = [&html](const char* id, const char* words) {
    html += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, words);
  };
  entry("short", "In short");
  entry("entry", "Entry: error against time, scene by scene");
  entry("clip", "Clip");
  entry("step", "Step");
  if (!measured.left_out.empty()) entry("left-out", "What fast leaves out, and what that is worth");
  if (!measured.trajectories.empty()) entry("motions", "Motions: error against run time");
  if (!measured.cells.empty()) entry("stability", "Where the integrators hold");
  entry("omissions", "What is missing here");
  return html + "</ul></nav>\n";
}

std::string tier_list(const Measured& measured) {
  HtmlTable table("The tiers", {{"tier", Align::words}, {"what it is", Align::words}});
  for (const precision::TierResult& result : measured.studies.front().results)
    table.add({escaped(result.tier), escaped(result.description)});
  return table.finished();
}

std::string heading(const char* id, const char* words) {
  return fmt::format("<h2 id=\"{}\">{}</h2>\n", id, words);
}

}  // namespace

std::string provenance_of(const Measured& measured) {
  return fmt::format("Seed {}; {}; {}, {}; commit {}.", measured.seed, measured.machine.processor,
                     measured.machine.compiler, measured.machine.flags, measured.machine.commit);
}

std::string page_of(const Measured& measured) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head><meta "
      "charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>Groundtruth: error against time</title>\n<style>{}</style></head>\n<body><main>\n"
      "<h1>Ground contact: how much error for how much time</h1>\n",
      page_style);
  html += introduction + facts_of(measured) + contents_of(measured);
  html += heading("short", "In short") + short_table(measured) + tier_list(measured);
  html += heading("entry", "Entry: error against time, scene by scene");
  html +=
      "<p>Left is quicker, down is better. The upper part of a chart holds tiers that answered some asks "
      "wrongly, or not at all; the lower part those that were always right, by their worst error.</p>\n";
  html += study_sections(measured, tiers::AskKind::entry);
  html += heading("clip", "Clip: the force that a contact can bear");
  html += study_sections(measured, tiers::AskKind::clip);
  html += heading("step", "Step: a wheel's next state and force");
  html += study_sections(measured, tiers::AskKind::step);
  if (!measured.left_out.empty()) {
    html += heading("left-out", "What fast leaves out, and what that is worth");
    html +=
        "<p>Before it is asked anything, <strong>fast</strong> compiles the scene: it drops what no answer "
        "depends on, and indexes the rest. Each row compiles the same scene without one of these.</p>\n";
    html += left_out_section(measured);
  }
  if (!measured.trajectories.empty()) {
    html += heading("motions", "Motions: error against run time");
    html +=
        "<p>A body on wheels is set in motion with ever shorter steps. Down is better, left is quicker; a "
        "method of order 2 falls along the steeper dotted line.</p>\n";
    html += trajectory_section(measured);
  }
  if (!measured.cells.empty())
    html += heading("stability", "Where the integrators hold") + stability_section(measured);
  html += heading("omissions", "What is missing here") + omission_section(measured);
  return html + "</main></body></html>\n";
}

std::string summary_of(const Measured& measured) {
  std::string text = fmt::format("{:<6}{:<12}{:<10}{:>11}{:>10}{:>7}{:>11}{:>14}{:>11}\n", "ask", "scene",
                                 "asks", "fast", "worst ulp", "wrong", "double", "wrong", "exact");
  for (const Study& study : measured.studies) {
    const auto result = [&](const char* tier) -> const precision::TierResult& {
      for (const auto& one : study.results)
        if (one.tier == tier) return one;
      return study.results.front();
    };
    const auto &fast = result("fast"), &plain = result("double");
    text += fmt::format("{:<6}{:<12}{:<10}{:>11}{:>10}{:>7}{:>11}{:>14}{:>11}\n",
                        precision::name_of(study.kind), study.scene, precision::name_of(study.population),
                        duration_in_words(fast.nanoseconds.median), short_number(fast.worst_ulps), fast.wrong,
                        duration_in_words(plain.nanoseconds.median),
                        fmt::format("{} of {}", plain.wrong, plain.asks),
                        duration_in_words(result("exact").nanoseconds.median));
  }
  return text;
}

}  // namespace groundtruth::report
