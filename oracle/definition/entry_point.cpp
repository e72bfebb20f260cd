#include <groundtruth/definition/entry_point.hpp>
#include <groundtruth/definition/faces.hpp>
#include <groundtruth/definition/nearest_double.hpp>
#include <groundtruth/definition/prepared_scene.hpp>

namespace groundtruth::definition {

EntryFinding entry_point(const Scene& scene, const EntryAsk& ask) {
  const Triple<Rational> from = rational(ask.from);
  const Triple<Rational> run = rational(ask.to) - from;
  const Rational lambda_first = rational(ask.lambda_first);
  const Rational lambda_last = rational(ask.lambda_last);
  const Segment segment = segment_between(real(from + lambda_first * run), real(from + lambda_last * run));

  const Expression& solid = scene.prepared().solid;
  const std::optional<Moment> moment = first_member(solid, segment);
  if (!moment) return {Miss{}, {}};

  const Rational theta(moment->numerator.plain(), moment->denominator);
  const Rational exact = lambda_first + (lambda_last - lambda_first) * theta;
  const double lambda = *nearest_double(exact);  // it lies between two doubles
  const Faces faces = faces_at(solid, segment, *moment);
  if (faces.interior) return {Inside{lambda}, {exact.str(), {}, {}}};

  const Leaf leaf = faces.admissible.front();
  const Border border{lambda, leaf, solid.half_spaces[leaf].normal_as_written,
                      material_at(solid, leaf, point_at(segment, *moment))};
  return {border, {exact.str(), faces.admissible, {}}};
}

}  // namespace groundtruth::definition
