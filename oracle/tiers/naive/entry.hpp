#pragma once
// The entry point (SPEC section 3) in any arithmetic.

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/tiers/naive/faces.hpp>
#include <groundtruth/tiers/naive/reach.hpp>

namespace groundtruth::tiers::naive {

template <class Real>
struct Entered {
  Real lambda;
  Vector3<Real> point;
  const Node<Real>* face = nullptr;  // null: interior
  std::optional<MaterialIndex> material;
};

template <class Real>
std::optional<Entered<Real>> entered(const Ground<Real>& ground, const Segment<Real>& segment) {
  const auto place = first_reached(ground.solid, 0, segment, segment.start());
  if (!place) return std::nullopt;
  Entered<Real> result{
      place->lambda, segment.at(place->lambda), canonical_face(ground.solid, segment, *place), {}};
  if (result.face) result.material = ground.material_at(result.face->leaf, result.point);
  return result;
}

template <class Real>
EntryAnswer entry_point(const Ground<Real>& ground, const EntryAsk& ask) {
  const Segment<Real> segment(as<Real>(ask.from), as<Real>(ask.to), Real(ask.lambda_first),
                              Real(ask.lambda_last));
  const auto found = entered(ground, segment);
  if (!found) return Miss{};
  const double lambda = as_double(found->lambda);
  if (!found->face) return Inside{lambda};
  return Border{lambda, found->face->leaf, found->face->written.normal, found->material};
}

}  // namespace groundtruth::tiers::naive
