#include <groundtruth/page/text_page.hpp>

#include <fmt/color.h>
#include <fmt/format.h>

#include <groundtruth/explanation/explanation.hpp>

#include "words.hpp"

namespace groundtruth::page {
namespace {

using namespace explanation;

class TextPage {
 public:
  TextPage(const Explanation& explanation, Colours colours) : explanation_(explanation), colours_(colours) {}

  std::string write(const std::string& replay_command) && {
    heading(explanation_.asked.id);
    if (!explanation_.asked.note.empty()) text_ += explanation_.asked.note + "\n";
    text_ += explanation_.in_words + "\n";
    lines(lambda_lines(explanation_));
    std::visit([this](const auto& facts) { write(facts); }, explanation_.facts);
    opinions();
    heading("Again");
    text_ += "  " + replay_command + "\n";
    return std::move(text_);
  }

 private:
  std::string painted(const std::string& words, fmt::text_style style) const {
    return colours_ == Colours::ansi ? fmt::format(style, "{}", words) : words;
  }
  void heading(const std::string& words) {
    if (!text_.empty()) text_ += "\n";
    text_ += painted(words, fmt::emphasis::bold) + "\n";
  }
  void lines(const std::vector<Line>& all) {
    std::size_t width = 0;
    for (const auto& [name, value] : all) width = std::max(width, name.size());
    for (const auto& [name, value] : all) text_ += fmt::format("  {:<{}}  {}\n", name, width, value);
  }

  void write(const EntryFacts& facts) {
    if (!facts.decision.meeting.faces.empty()) heading("Faces that meet there");
    const RationalVector point = facts.segment.at(facts.decision.lambda.value_or(Rational(0)));
    for (const TiedFace& face : facts.decision.meeting.faces) {
      const Plane& plane = facts.in_play.planes[face.plane];
      const bool named = facts.decision.canonical == face.plane;
      const bool may = facts.decision.meeting.is_admissible(face);
      const std::string mark = named ? "named" : may ? "may be named" : "no";
      text_ += fmt::format("  leaf {:<5} {:<13} {} ({})\n    {}\n", plane.leaf,
                           painted(fmt::format("{:<13}", mark),
                                   fg(may ? fmt::terminal_color::green : fmt::terminal_color::red)),
                           formula_of(plane),
                           name_of(material_at(facts.in_play, face.plane, point), explanation_.asked.scene),
                           facts.decision.meeting.interior ? "the point lies inside the solid: no face is met"
                                                           : reason_of(face.role));
    }
    heading("How near another decision is");
    for (const Flip& flip : facts.search.flips) text_ += "  " + words_of(flip, facts) + "\n";
    if (const std::string more = words_of_search(facts); !more.empty()) text_ += "  " + more + "\n";
    along_the_segment(facts);
  }

  void along_the_segment(const EntryFacts& facts) {
    heading("Along the segment");
    if (facts.reach)
      text_ +=
          fmt::format("  {} of {} leaves; the others decide the same within {:g} m around the segment.\n",
                      facts.in_play.planes.size(), facts.leaves_in_all, *facts.reach);
    for (const Stop& stop : facts.stops) {
      std::string leaves;
      for (std::size_t at = 0; at < facts.in_play.nodes.size(); ++at) {
        const Node& node = facts.in_play.nodes[at];
        if (node.part == Part::leaf && stop.lit[at])
          leaves += fmt::format(" {}", facts.in_play.planes[node.plane].leaf);
      }
      const std::string in = stop.lit.front() ? painted("in ", fg(fmt::terminal_color::green)) : "out";
      text_ +=
          fmt::format("  {:<40} {}  leaves true:{}\n", words_of(stop), in, leaves.empty() ? " none" : leaves);
    }
  }

  void write(const ClipFacts& facts) {
    heading("The border");
    lines(clip_lines(facts));
  }

  void write(const StepFacts& facts) {
    heading(fmt::format("The way from {} to {}", facts.from, facts.to));
    for (const Question& question : facts.questions) {
      const std::string answer = question.holds ? "yes" : "no ";
      text_ += fmt::format(
          "  {}  {}",
          painted(answer, fg(question.holds ? fmt::terminal_color::yellow : fmt::terminal_color::green)),
          question.asks);
      if (!question.leads_to.empty()) text_ += " -> " + question.leads_to;
      text_ += "\n";
      if (!question.left.empty()) text_ += fmt::format("       {} against {}", question.left, question.right);
      if (!question.margin.empty()) text_ += fmt::format("; {} apart", question.margin);
      if (!question.left.empty()) text_ += "\n";
    }
    if (facts.clip) write(*facts.clip);
    if (facts.landing) write(*facts.landing);
  }

  void opinions() {
    heading("Who answers what");
    for (const Opinion& opinion : explanation_.opinions) {
      if (opinion.difference.empty()) {
        text_ +=
            fmt::format("  {:<36}  {}\n", opinion.who, painted("the same", fg(fmt::terminal_color::green)));
      } else {
        text_ += fmt::format("  {:<36}  {}\n    {}\n", opinion.who,
                             painted(opinion.difference, fg(fmt::terminal_color::red)), opinion.line);
      }
    }
  }

  const Explanation& explanation_;
  Colours colours_;
  std::string text_;
};

}  // namespace

std::string text_page(const Explanation& explanation, const std::string& replay_command, Colours colours) {
  return TextPage(explanation, colours).write(replay_command);
}

}  // namespace groundtruth::page
