#include "words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <groundtruth/text/number_text.hpp>

namespace groundtruth::page {
namespace {

using namespace explanation;

std::string signed_root(int sign, const Rational& squared) {
  return (sign < 0 ? "-" : "") + write_root(squared) + " N";
}

// How far sqrt(left) is from sqrt(right), both as decimals.
std::string gap(const Rational& left_squared, const Rational& right_squared) {
  if (left_squared == right_squared) return "exactly on it";
  const double gap = std::abs(nearby_root(left_squared) - nearby_root(right_squared));
  return fmt::format("{:.6g} N {}", gap, left_squared < right_squared ? "inside" : "outside");
}

std::string end_of(const Decision& decision, const EntryFacts& facts) {
  if (!decision.lambda) return "the segment misses";
  if (decision.is_inside()) return "the segment starts inside";
  return fmt::format("the segment hits leaf {} at lambda {}", facts.in_play.planes[*decision.canonical].leaf,
                     write_fraction(*decision.lambda));
}

}  // namespace

std::string words_of(const Vector& v) {
  return fmt::format("({}, {}, {})", write_decimal(v[0]), write_decimal(v[1]), write_decimal(v[2]));
}

std::string words_of(const Stop& stop) {
  if (stop.is_breakpoint()) return write_fraction(stop.from);
  return fmt::format("between {} and {}", write_fraction(stop.from), write_fraction(stop.to));
}

std::string formula_of(const Plane& plane) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const double factor = plane.normal_as_written[i];
    if (factor == 0) continue;
    const double size = std::abs(factor);
    text += text.empty() ? (factor < 0 ? "-" : "") : (factor < 0 ? " - " : " + ");
    if (size != 1) text += write_decimal(size) + " ";
    text += "xyz"[i];
  }
  return (text.empty() ? "0" : text) + " <= " + write_decimal(plane.offset.convert_to<double>());
}

std::string name_of(const std::optional<MaterialIndex>& material, const Scene& scene) {
  return material ? scene.materials[*material].name : "no material";
}

std::vector<Line> lambda_lines(const Explanation& explanation) {
  const auto* facts = std::get_if<EntryFacts>(&explanation.facts);
  if (facts == nullptr || !facts->decision.lambda) return {};
  const auto& answer = std::get<EntryAnswer>(explanation.answer);
  const auto* border = std::get_if<Border>(&answer);
  const double lambda = border ? border->lambda : std::get<Inside>(answer).lambda;
  const RationalVector point = facts->segment.at(*facts->decision.lambda);
  return {{"lambda, exact", write_fraction(*facts->decision.lambda)},
          {"in decimals", write_approximately(*facts->decision.lambda)},
          {"nearest double", fmt::format("{} = {}", write_decimal(lambda), write_hex_float(lambda))},
          {"point", fmt::format("({}, {}, {})", write_approximately(point[0]), write_approximately(point[1]),
                                write_approximately(point[2]))}};
}

std::string words_of(const Flip& flip, const EntryFacts& facts) {
  const Leaf leaf = facts.in_play.planes[flip.plane].leaf;
  const std::string end = end_of(flip.becomes, facts);
  if (flip.offset_change == 0)
    return fmt::format("Leaf {} moved {} by anything at all: {}.", leaf, flip.side > 0 ? "out" : "in", end);
  return fmt::format("Leaf {} with its offset {} by {} (the plane moves {} m){}: {}.", leaf,
                     flip.side > 0 ? "raised" : "lowered", write_fraction(abs(flip.offset_change)),
                     write_root(flip.metres_squared), flip.is_reached ? "" : " and any more", end);
}

std::string words_of_search(const EntryFacts& facts) {
  if (!facts.search.is_complete)
    return fmt::format(
        "The search ended after {} changes; another decision may be nearer than those not named.",
        facts.search.tried);
  const auto flips = [&](Flips what) {
    return std::any_of(facts.search.flips.begin(), facts.search.flips.end(),
                       [&](const Flip& flip) { return flip.what == what; });
  };
  const bool hits = facts.decision.lambda.has_value();
  if (flips(Flips::hit_or_miss) && (flips(Flips::face) || !hits)) return "";
  const std::string which =
      facts.reach ? fmt::format("moved by up to {} m", write_decimal(*facts.reach)) : "moved";
  return fmt::format("No single plane, {}, makes it {}.", which,
                     !hits                       ? "a hit"
                     : flips(Flips::hit_or_miss) ? "another face"
                                                 : "a miss");
}

std::vector<Line> clip_lines(const ClipFacts& facts) {
  std::vector<Line> lines{{"case", std::string(explanation::name_of(facts.which))}};
  if (facts.which == ClipCase::too_steep) return lines;
  const Rational brake_squared = facts.brake * facts.brake;
  lines.emplace_back("F'_x", signed_root(facts.x_sign, facts.x_squared));
  lines.emplace_back("F'_y", signed_root(facts.y_sign, facts.y_squared));
  lines.emplace_back("N", write_root(facts.normal_squared) + " N");
  lines.emplace_back("to the brake's band |x| = B", gap(facts.x_squared, brake_squared));
  lines.emplace_back("to the friction disc's edge mu N",
                     gap(facts.tangential_squared(), facts.disc_squared()));
  if (facts.normal_squared != 0)
    lines.emplace_back("friction at which the force lies on the disc's edge",
                       write_root(facts.tangential_squared() / facts.normal_squared));
  return lines;
}

}  // namespace groundtruth::page
