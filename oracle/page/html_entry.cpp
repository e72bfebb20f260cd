#include <algorithm>

#include <fmt/format.h>

#include "cross_section.hpp"
#include "html_section.hpp"
#include "markup.hpp"
#include "words.hpp"

namespace groundtruth::page {
namespace {

using namespace explanation;

// Where the slider stands at first: where the solid is entered.
std::size_t first_stop(const EntryFacts& facts) {
  for (std::size_t i = 0; i < facts.stops.size(); ++i)
    if (facts.stops[i].is_breakpoint() && facts.stops[i].from == facts.decision.lambda) return i;
  return 0;
}

std::string words_of_node(const EntryFacts& facts, const Node& node, const Scene& scene) {
  switch (node.part) {
    case Part::everything:
      return "everything";
    case Part::nothing:
      return "nothing";
    case Part::united:
      return "union";
    case Part::intersected:
      return "intersection";
    case Part::covered:
      return "material " + scene.materials[node.material].name;
    case Part::painted:
      return "paint " + scene.materials[node.material].name + " on a region";
    case Part::leaf:
      break;
  }
  const Plane& plane = facts.in_play.planes[node.plane];
  return fmt::format("leaf {}: {}", plane.leaf, formula_of(plane));
}

class Tree {
 public:
  Tree(const EntryFacts& facts, const Scene& scene)
      : facts_(facts), scene_(scene), lit_(facts.stops[first_stop(facts)].lit) {
    for (const TiedFace& face : facts.decision.meeting.faces) tied_.push_back(face.plane);
  }

  std::string write(std::size_t at = 0) const {
    const Node& node = facts_.in_play.nodes[at];
    const bool is_tied =
        node.part == Part::leaf && std::find(tied_.begin(), tied_.end(), node.plane) != tied_.end();
    std::string html = fmt::format(
        "<li><span class=\"node {0}\" data-node=\"{1}\"{2}><b>{0}</b> {3}{4}</span>",
        lit_[at] ? "true" : "false", at,
        node.part == Part::leaf ? fmt::format(" data-leaf=\"{}\"", facts_.in_play.planes[node.plane].leaf)
                                : "",
        escaped(words_of_node(facts_, node, scene_)), is_tied ? " <em>meets there</em>" : "");
    std::string inner;
    for (std::size_t operand = at + 1; operand < node.end; operand = facts_.in_play.nodes[operand].end)
      inner += write(operand);
    return html + (inner.empty() ? "" : "\n<ul>\n" + inner + "</ul>\n") + "</li>\n";
  }

 private:
  const EntryFacts& facts_;
  const Scene& scene_;
  const std::vector<bool>& lit_;
  std::vector<std::size_t> tied_;
};

std::string data_of(const EntryFacts& facts, const CrossSection& section) {
  std::string data = "<script type=\"application/json\" class=\"stops\">[\n";
  for (std::size_t i = 0; i < facts.stops.size(); ++i) {
    std::string bits;
    for (const bool lit : facts.stops[i].lit) bits += lit ? '1' : '0';
    data += fmt::format("{}{{\"lambda\":\"{}\",\"at\":{:.17g},\"lit\":\"{}\"}}", i == 0 ? "" : ",\n",
                        words_of(facts.stops[i]), section.stops[i], bits);
  }
  return data + "]</script>\n";
}

std::string controls(const EntryFacts& facts, const CrossSection& section) {
  const std::size_t stop = first_stop(facts);
  std::string html = fmt::format(
      "<div class=\"controls\"><label>lambda <input class=\"lambda\" type=\"range\" min=\"0\" max=\"{}\" "
      "value=\"{}\" "
      "aria-valuetext=\"{}\"></label> <output class=\"where\">{}: {}</output>\n",
      facts.stops.size() - 1, stop, words_of(facts.stops[stop]), words_of(facts.stops[stop]),
      facts.stops[stop].lit.front() ? "in the solid" : "outside");
  if (section.zooms.size() > 1) {
    html += "<label>zoom <select class=\"zoom-choice\">";
    for (std::size_t i = 0; i < section.zooms.size(); ++i)
      html += fmt::format("<option value=\"{}\">{}</option>", i, escaped(section.zooms[i]));
    html += "</select></label>";
  }
  return html + "</div>\n";
}

std::string legend_of(const CrossSection& section, const Scene& scene) {
  std::string html = "<ul class=\"legend\">";
  for (const auto& material : section.materials)
    html += fmt::format("<li><span class=\"swatch {}\"></span>{}</li>",
                        material ? fmt::format("m{}", *material % 6) : "m-none",
                        escaped(name_of(material, scene)));
  return html +
         "<li><span class=\"swatch line-segment\"></span>the segment</li>"
         "<li><span class=\"swatch line-face\"></span>a face it may be said to enter</li>"
         "<li><span class=\"swatch line-seam\"></span>a plane there that is no such face</li>"
         "<li><span class=\"swatch ring\"></span>lambda on the slider</li></ul>\n";
}

std::string faces_of(const EntryFacts& facts, const Scene& scene) {
  const Decision& decision = facts.decision;
  if (decision.meeting.faces.empty()) return "";
  std::string html =
      "<h3>Faces that meet there</h3>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Faces\"><table class=\"faces\"><thead><tr><th>leaf</th><th>half-space</th>"
      "<th>material</th><th>may be named</th><th>why</th></tr></thead><tbody>\n";
  const RationalVector point = facts.segment.at(decision.lambda.value_or(Rational(0)));
  for (const TiedFace& face : decision.meeting.faces) {
    const bool may = decision.meeting.is_admissible(face);
    html += fmt::format(
        "<tr class=\"{}\"><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", may ? "yes" : "no",
        facts.in_play.planes[face.plane].leaf, escaped(formula_of(facts.in_play.planes[face.plane])),
        escaped(name_of(material_at(facts.in_play, face.plane, point), scene)),
        decision.canonical == face.plane ? "yes, and is: the smallest number"
        : may                            ? "yes"
                                         : "no",
        decision.meeting.interior ? "the point lies inside the solid: no face is met" : reason_of(face.role));
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string html_of_entry(const EntryFacts& facts, const Scene& scene, double lambda) {
  const CrossSection section = cross_section_of(facts, lambda);
  std::string html =
      "<div class=\"entry\">\n<h3>Along the segment</h3>\n<p>The slider stops at every exact breakpoint "
      "of lambda, where a half-space is entered or left, and between them.</p>\n";
  html += controls(facts, section);
  html += "<div class=\"beside\"><figure>" + section.picture + legend_of(section, scene) + "</figure>\n";
  html += "<div class=\"expression\"><h4>The expression at lambda</h4>\n";
  if (facts.reach)
    html +=
        fmt::format("<p>{} of {} leaves: the others decide the same within {:g} m around the segment.</p>\n",
                    facts.in_play.planes.size(), facts.leaves_in_all, *facts.reach);
  html +=
      "<ul class=\"tree\">\n" + Tree(facts, scene).write() + "</ul></div></div>\n" + data_of(facts, section);
  html += faces_of(facts, scene) + "<h3>How near another decision is</h3>\n<ul>\n";
  for (const Flip& flip : facts.search.flips) html += "<li>" + escaped(words_of(flip, facts)) + "</li>\n";
  if (const std::string more = words_of_search(facts); !more.empty())
    html += "<li>" + escaped(more) + "</li>\n";
  return html + "</ul>\n</div>\n";
}

}  // namespace groundtruth::page
