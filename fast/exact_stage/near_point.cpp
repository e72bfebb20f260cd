#include <groundtruth/fast/exact_stage/near_point.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

class LeavesLeft {
 public:
  LeavesLeft(const LeavesNearPoint& near, boost::container::small_vector<std::size_t, 64>& left)
      : near_(near), left_(left) {}

  Truth add(std::size_t leaf) {
    if (near_[leaf] == NearPoint::nothing) return Truth::no;
    if (near_[leaf] == NearPoint::everything) return Truth::yes;
    left_.push_back(leaf);
    return Truth::open;
  }
  std::size_t size() const { return left_.size(); }
  void resize(std::size_t size) { left_.resize(size); }

 private:
  const LeavesNearPoint& near_;
  boost::container::small_vector<std::size_t, 64>& left_;
};

}  // namespace

Standing::Standing(const ExpressionView& solid, const LeavesNearPoint& near) {
  LeavesLeft left(near, leaves_);
  value_ = Simplifier(left, nodes_).add(solid.nodes.data());
}

}  // namespace groundtruth::fast::exact_stage
