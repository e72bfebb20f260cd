#include "meeting.hpp"

#include <algorithm>
#include <cmath>

namespace groundtruth::planted {
Meeting::Meeting(const Right& right_answers, const EntryAsk& one_ask, const Border& right_border)
    : right(right_answers), ask(one_ask), border(right_border) {
  const Evidence evidence = right.evidence(ask);
  admissible = evidence.admissible;
  const Rational lambda(evidence.lambda_exact);
  const Place from = place(ask.from);
  const Place to = place(ask.to);
  for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = from[axis] + lambda * (to[axis] - from[axis]);
  at_start = lambda == Rational(ask.lambda_first);
}

std::vector<Leaf> Meeting::tied() const {
  std::vector<Leaf> leaves;
  const Vector nearby = doubles(point);
  for (Leaf leaf = 0; leaf < right.leaves().size(); ++leaf) {
    const auto& [normal, offset] = half_space(leaf);
    if (normal == Vector{}) continue;
    double distance = -offset;
    double size = std::abs(offset);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      distance += normal[axis] * nearby[axis];
      size += std::abs(normal[axis] * nearby[axis]);
    }
    // Far more than doubles err; long numbers are slow.
    if (std::abs(distance) > 1e-9 * size) continue;
    if (side_of(half_space(leaf), point) == 0) leaves.push_back(leaf);
  }
  return leaves;
}

bool Meeting::is_admissible(Leaf leaf) const {
  return std::binary_search(admissible.begin(), admissible.end(), leaf);
}

double Meeting::advance(Leaf leaf) const {
  const Numbers direction = numbers(ask.to) - numbers(ask.from);
  return static_cast<double>(dot(numbers(half_space(leaf).normal), direction));
}

Border Meeting::on(Leaf leaf) const {
  return {border.lambda, leaf, half_space(leaf).normal, material_of(right.leaves()[leaf], point)};
}

std::size_t planes_among(const Meeting& meeting, const std::vector<Leaf>& leaves) {
  std::vector<Numbers> normals;
  for (const Leaf leaf : leaves) {
    const Numbers normal = numbers(meeting.half_space(leaf).normal);
    const auto is_parallel = [&](const Numbers& other) {
      return compare(length(cross(normal, other)), 0, length(normal) * length(other)) == 0;
    };
    if (std::none_of(normals.begin(), normals.end(), is_parallel)) normals.push_back(normal);
  }
  return normals.size();
}

}  // namespace groundtruth::planted
