#include <groundtruth/definition/sample.hpp>

namespace groundtruth::definition {
namespace {

// A number of doublings after which |height| exceeds |slope|. Requires height != 0.
unsigned doublings_to_exceed(const Whole& height, const Integer& slope, unsigned at_least) {
  const Whole magnitude = absolute(height);
  const Whole limit = Integer(abs(slope));
  unsigned doublings = at_least;
  while (magnitude * power_of_two(doublings) <= limit) doublings += 8;
  return doublings;
}

}  // namespace

Sample sample_at(const Expression& expression, const Point& point) {
  Sample result;
  result.heights = heights(expression, point);
  result.sides = sides(expression, result.heights);
  return result;
}

Sample moved(const Expression& expression, const Sample& from, const Triple<Integer>& direction) {
  const std::size_t leaves = expression.half_spaces.size();
  std::vector<Integer> slopes(leaves);
  unsigned doublings = 0;
  for (Leaf leaf = 0; leaf < leaves; ++leaf) {
    slopes[leaf] = dot(expression.half_spaces[leaf].normal, direction);
    if (!from.on_plane_of(leaf) && !slopes[leaf].is_zero())
      doublings = doublings_to_exceed(from.heights[leaf], slopes[leaf], doublings);
  }
  // All heights are multiplied by 2^doublings, as if the step were 2^-doublings long.
  const Integer factor = power_of_two(doublings);
  Sample result;
  result.heights.reserve(leaves);
  for (Leaf leaf = 0; leaf < leaves; ++leaf)
    result.heights.push_back(from.heights[leaf] * factor + Whole(slopes[leaf]));
  result.sides = sides(expression, result.heights);
  return result;
}

}  // namespace groundtruth::definition
