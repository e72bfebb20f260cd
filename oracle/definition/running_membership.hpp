#pragma once
// Membership of a point that moves: the truth of every node, kept up to date as leaves change sides.

#include <vector>

#include <groundtruth/definition/expression.hpp>

namespace groundtruth::definition {

class RunningMembership {
 public:
  // Keeps a reference to `expression`.
  RunningMembership(const Expression& expression, const Sides& sides);

  void enter(Leaf leaf) { set(expression_.node_of_leaf[leaf], true); }
  void leave(Leaf leaf) { set(expression_.node_of_leaf[leaf], false); }
  bool is_member() const { return member_.front(); }

 private:
  void set(std::size_t node, bool member);

  const Expression& expression_;
  std::vector<bool> member_;
  std::vector<std::size_t> member_operands_;
};

}  // namespace groundtruth::definition
