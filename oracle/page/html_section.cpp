#include "html_section.hpp"

#include <fmt/format.h>

#include <groundtruth/text/ask_text.hpp>
#include <groundtruth/text/scene_text.hpp>

#include "force_pictures.hpp"
#include "markup.hpp"
#include "words.hpp"

namespace groundtruth::page {
namespace {

using namespace explanation;

double lambda_of(const Answer& answer) {
  const auto* entry = std::get_if<EntryAnswer>(&answer);
  if (entry == nullptr) return 0;
  if (const auto* border = std::get_if<Border>(entry)) return border->lambda;
  if (const auto* inside = std::get_if<Inside>(entry)) return inside->lambda;
  return 0;
}

std::string html_of_clip(const ClipFacts& facts) {
  return "<h3>The friction border</h3>\n<div class=\"beside\"><figure>" + clip_picture(facts) +
         "<ul class=\"legend\"><li><span class=\"swatch border-swatch\"></span>stick: disc and band</li>"
         "<li><span class=\"swatch line-before\"></span>force before</li>"
         "<li><span class=\"swatch line-after\"></span>force after</li></ul></figure>\n" +
         html_of_lines(clip_lines(facts)) + "</div>\n";
}

std::string html_of_questions(const StepFacts& facts) {
  std::string html =
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Questions\"><table "
      "class=\"questions\"><thead><tr><th>asked in this order</th><th>is</th><th>against</th><th>apart</th>"
      "<th>so</th></tr></thead><tbody>\n";
  for (const Question& question : facts.questions)
    html +=
        fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}{}</td></tr>\n",
                    escaped(question.asks), escaped(question.left), escaped(question.right), question.margin,
                    question.holds ? "yes" : "no", question.leads_to.empty() ? "" : ": " + question.leads_to);
  return html + "</tbody></table></div>\n";
}

class OfKind {
 public:
  explicit OfKind(const Explanation& explanation) : explanation_(explanation) {}

  std::string operator()(const EntryFacts& facts) const {
    return html_of_entry(facts, explanation_.asked.scene, lambda_of(explanation_.answer));
  }
  std::string operator()(const ClipFacts& facts) const { return html_of_clip(facts); }
  std::string operator()(const StepFacts& facts) const {
    const Wheel& wheel = std::get<StepAsk>(explanation_.asked.ask).wheel;
    std::string html = fmt::format(
        "<h3>From {} to {}</h3>\n<div class=\"beside\"><figure>{}</figure>\n<figure>{}"
        "<ul class=\"legend\"><li><span class=\"swatch line-before\"></span>the springs' force on the "
        "pebble</li>"
        "<li><span class=\"swatch line-after\"></span>what is left of it</li>"
        "<li><span class=\"swatch dot\"></span>pebble before</li>"
        "<li><span class=\"swatch ring-after\"></span>pebble after</li></ul></figure></div>\n",
        facts.from, facts.to, machine_picture(facts), side_view(facts, wheel));
    html += html_of_questions(facts);
    if (facts.clip) html += html_of_clip(*facts.clip);
    if (!facts.landing) return html;
    const std::optional<Rational>& lambda = facts.landing->decision.lambda;
    return html + html_of_entry(*facts.landing, explanation_.asked.scene, lambda ? nearby(*lambda) : 0);
  }

 private:
  const Explanation& explanation_;
};

std::string html_of_opinions(const Explanation& explanation) {
  std::string html =
      "<h3>Who answers what</h3>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Answers\"><table class=\"opinions\"><thead><tr><th>who</th><th>against "
      "exact</th><th>answer</th>"
      "</tr></thead><tbody>\n";
  for (const Opinion& opinion : explanation.opinions) {
    const bool same = opinion.difference.empty();
    html += fmt::format("<tr class=\"{}\"><td>{}</td><td>{}</td><td><code>{}</code></td></tr>\n",
                        same ? "same" : "differs", escaped(opinion.who),
                        same ? "the same" : escaped(opinion.difference),
                        same && opinion.who != "exact" ? "" : escaped(opinion.line));
  }
  return html + "</tbody></table></div>\n";
}

std::string html_of_texts(const Section& section) {
  const cases::Case& asked = section.explanation.asked;
  const std::string scene = write_scene(asked.scene);
  constexpr std::size_t most = 4000;
  std::string html = "<details><summary>The ask, the scene and the exact answer</summary>\n";
  html += "<pre tabindex=\"0\">" + escaped(write_ask("null", asked.ask)) + "\n\n";
  html += scene.size() <= most ? escaped(scene) : fmt::format("a scene of {} bytes", scene.size());
  return html + "\n\n" + escaped(section.explanation.answer_line) + "</pre></details>\n";
}

}  // namespace

std::string html_of_lines(const std::vector<std::pair<std::string, std::string>>& lines) {
  if (lines.empty()) return "";
  std::string html = "<dl>\n";
  for (const auto& [name, value] : lines)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(value));
  return html + "</dl>\n";
}

std::string html_section(const Section& section) {
  const Explanation& explanation = section.explanation;
  std::string html = fmt::format("<p class=\"answer\">{}</p>\n", escaped(explanation.in_words));
  if (!explanation.asked.note.empty()) html += fmt::format("<p>{}</p>\n", escaped(explanation.asked.note));
  for (const std::string& remark : section.remarks) html += fmt::format("<p>{}</p>\n", escaped(remark));
  html += html_of_lines(lambda_lines(explanation));
  html += std::visit(OfKind(explanation), explanation.facts);
  html += html_of_opinions(explanation);
  html += fmt::format(
      "<h3>Again</h3>\n<p class=\"replay\"><code>{}</code> <button type=\"button\" "
      "class=\"copy\">copy</button></p>\n",
      escaped(section.replay_command));
  return html + html_of_texts(section);
}

}  // namespace groundtruth::page
