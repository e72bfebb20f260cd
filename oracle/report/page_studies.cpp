#include <groundtruth/report/page_sections.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <groundtruth/report/html.hpp>
#include <groundtruth/report/work_precision_plot.hpp>

namespace groundtruth::report {
namespace {

using precision::Population;
using precision::TierResult;
using precision::Witness;

std::vector<const Study*> studies_of(const Measured& measured, const Study& first) {
  std::vector<const Study*> studies;
  for (const Study& study : measured.studies)
    if (study.scene == first.scene && study.kind == first.kind) studies.push_back(&study);
  return studies;
}

std::string place_of(const Study& study, const std::optional<Witness>& witness) {
  if (!witness) return "";
  return fmt::format("<code>{}:{}:{}</code>", escaped(study.scene), witness->part, witness->index);
}

std::string counted(std::size_t count) {
  return count == 0 ? "<span class=\"good\">0</span>" : fmt::format("<span class=\"bad\">{}</span>", count);
}

std::string table_of(const Study& study) {
  HtmlTable table(fmt::format("{} asks. Marked rows are on the front: nothing else is as quick and as good.",
                              precision::name_of(study.population)),
                  {{"tier", Align::words},
                   {"asks"},
                   {"wrong"},
                   {"undecided"},
                   {"median error, ulp"},
                   {"worst error found, ulp"},
                   {"time per ask"},
                   {"least to most"},
                   {"asks timed"},
                   {"worst ask", Align::words},
                   {"first wrong ask", Align::words}});
  for (const TierResult& result : study.results) {
    const std::string name = escaped(result.tier);
    if (!result.omitted.empty()) {
      table.add({name, "", "", "", "", "", "omitted", "", "", escaped(result.omitted), ""});
      continue;
    }
    table.add({name, std::to_string(result.asks), counted(result.wrong),
               result.undecided == 0 ? "0" : std::to_string(result.undecided),
               result.with_number == 0 ? "-" : short_number(result.median_ulps),
               result.with_number == 0 ? "-" : short_number(result.worst_ulps),
               duration_in_words(result.nanoseconds.median),
               fmt::format("{} – {}", duration_in_words(result.nanoseconds.least),
                           duration_in_words(result.nanoseconds.most)),
               std::to_string(result.timed_asks), place_of(study, result.worst),
               place_of(study, result.first_wrong)},
              result.is_on_front ? "best" : "");
  }
  return table.finished();
}

// The asks themselves, each once.
std::string asks_of(const std::vector<const Study*>& studies) {
  std::string html;
  std::vector<std::string> seen;
  const auto show = [&](const std::string& why, const std::optional<Witness>& witness) {
    if (!witness || std::find(seen.begin(), seen.end(), witness->ask) != seen.end()) return;
    seen.push_back(witness->ask);
    html += fmt::format("<p class=\"soft\">{}</p><pre>{}</pre>\n", escaped(why), escaped(witness->ask));
  };
  for (const Study* study : studies)
    for (const TierResult& result : study->results) {
      const std::string who = fmt::format("{}, {} asks", result.tier, precision::name_of(study->population));
      show(who + ": worst error", result.worst);
      show(who + ": first wrong answer", result.first_wrong);
    }
  return "<details><summary>The worst and the wrong asks, to copy</summary>\n" + html + "</details>\n";
}

std::string section_of(const Measured& measured, const Study& first) {
  const std::vector<const Study*> studies = studies_of(measured, first);
  const bool is_clip = first.kind == tiers::AskKind::clip;
  const std::string title =
      is_clip ? "clip" : fmt::format("{}: {}", precision::name_of(first.kind), first.scene);
  std::string html = fmt::format("<h3 id=\"{}-{}\">{}</h3>\n<figure>\n", precision::name_of(first.kind),
                                 first.scene, escaped(title));
  html += work_precision_plot(title, studies);
  html += fmt::format(
      "<figcaption>{}{} Every maximum is one that was found, a lower bound of the true one. {}"
      "</figcaption></figure>\n",
      is_clip ? "" : fmt::format("{} leaves. ", first.leaves),
      "Dashed: the front, of tiers that nothing beats in both. ✕ took wrong decisions, ○ left "
      "some open, ● took all rightly.",
      escaped(provenance_of(measured)));
  html += "<p class=\"soft\">To see an ask that the tables name, and its exact answer:</p>\n";
  html += fmt::format(
      "<pre>groundtruth check --seed {} --show {}:PART:INDEX | groundtruth answer --engine exact"
      "</pre>\n",
      measured.seed, escaped(first.scene));
  for (const Study* study : studies) html += table_of(*study);
  return html + asks_of(studies);
}

const TierResult& result_of(const Study& study, const std::string& tier) {
  return *std::find_if(study.results.begin(), study.results.end(),
                       [&](const TierResult& result) { return result.tier == tier; });
}

}  // namespace

std::string study_sections(const Measured& measured, tiers::AskKind kind) {
  std::string html;
  for (const Study& study : measured.studies)
    if (study.kind == kind && study.population == Population::ordinary) html += section_of(measured, study);
  return html;
}

std::string short_table(const Measured& measured) {
  HtmlTable table("Three tiers of thirteen, on every sample; wrong answers are counted, not averaged.",
                  {{"ask", Align::words},
                   {"scene", Align::words},
                   {"asks", Align::words},
                   {"fast: time"},
                   {"worst, ulp"},
                   {"wrong"},
                   {"on the front", Align::words},
                   {"double: time"},
                   {"worst, ulp"},
                   {"wrong"},
                   {"exact: time"}});
  for (const Study& study : measured.studies) {
    const TierResult &fast = result_of(study, "fast"), &plain = result_of(study, "double"),
                     &exact = result_of(study, "exact");
    table.add({std::string(precision::name_of(study.kind)),
               study.kind == tiers::AskKind::clip ? "" : escaped(study.scene),
               std::string(precision::name_of(study.population)), duration_in_words(fast.nanoseconds.median),
               short_number(fast.worst_ulps), counted(fast.wrong), fast.is_on_front ? "yes" : "no",
               duration_in_words(plain.nanoseconds.median), short_number(plain.worst_ulps),
               fmt::format("{} of {}", counted(plain.wrong), plain.asks),
               duration_in_words(exact.nanoseconds.median)});
  }
  return table.finished();
}

}  // namespace groundtruth::report
