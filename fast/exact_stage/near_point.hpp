#pragma once
// What a solid's leaves are near a point, and what of the solid is left there (SPEC section 3). Not
// installed.

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/exact_stage/entry.hpp>
#include <groundtruth/fast/simplify.hpp>

namespace groundtruth::fast::exact_stage {

// A leaf on whose plane the point lies is entered there or not; any other is constant.
enum class NearPoint : std::uint8_t { nothing, everything, entered, not_entered };

using LeavesNearPoint = boost::container::small_vector<NearPoint, 512>;

// The leaves of a solid that stand at a point once it is simplified there, and their expression.
class Standing {
 public:
  Standing(const ExpressionView& solid, const LeavesNearPoint& near);

  // Open: some leaf stands.
  Truth value() const { return value_; }
  // The places of those leaves.
  const boost::container::small_vector<std::size_t, 64>& leaves() const { return leaves_; }
  // The root first. Cells are ranges of `leaves`.
  const Node* expression() const { return nodes_.data(); }

 private:
  boost::container::small_vector<std::size_t, 64> leaves_;
  boost::container::small_vector<Node, 64> nodes_;
  Truth value_;
};

}  // namespace groundtruth::fast::exact_stage
