#include <groundtruth/exact/entry_point.hpp>

#include <groundtruth/exact/arithmetic/rounding.hpp>
#include <groundtruth/exact/solid/entry.hpp>

namespace groundtruth::exact {
namespace {

Segment<Rational> segment_of(const EntryAsk& ask) {
  const RationalVector from = to_rational(ask.from);
  const RationalVector direction = to_rational(ask.to) - from;
  return {{from.x(), from.y(), from.z()}, direction, Rational(ask.lambda_first), Rational(ask.lambda_last)};
}

}  // namespace

Finding<EntryAnswer> entry_point(const Scene& scene, const EntryAsk& ask, Digits digits) {
  const Ground& ground = scene.ground();
  const auto entry = find_entry(ground.solid, segment_of(ask));
  if (!entry) return {Miss{}, {}};
  Finding<EntryAnswer> finding{Miss{}, {entry->lambda.str(), entry->admissible, {}}};
  if (digits != Digits::none) {
    finding.evidence.enclosures = {
        decimal_enclosure("lambda", RootSum(entry->lambda), static_cast<unsigned>(digits))};
  }
  const double lambda = nearest_double(entry->lambda);
  if (entry->interior) {
    finding.answer = Inside{lambda};
  } else {
    const Leaf canonical = entry->admissible.front();
    finding.answer = Border{lambda, canonical, ground.solid.half_spaces[canonical].normal,
                            material_at(ground, canonical, entry->point)};
  }
  return finding;
}

}  // namespace groundtruth::exact
