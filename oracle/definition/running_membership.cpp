#include <groundtruth/definition/running_membership.hpp>

namespace groundtruth::definition {

RunningMembership::RunningMembership(const Expression& expression, const Sides& sides)
    : expression_(expression),
      member_(membership(expression, sides, Reading::closed)),
      member_operands_(expression.nodes.size()) {
  for (std::size_t i = 1; i < expression.nodes.size(); ++i)
    if (member_[i]) ++member_operands_[expression.nodes[i].parent];
}

void RunningMembership::set(std::size_t node, bool member) {
  while (member_[node] != member) {
    member_[node] = member;
    if (node == 0) return;
    node = expression_.nodes[node].parent;
    member ? ++member_operands_[node] : --member_operands_[node];
    const Node& parent = expression_.nodes[node];
    const bool any = parent.kind == Node::Kind::any_operand;
    member = any ? member_operands_[node] > 0 : member_operands_[node] == parent.operands;
  }
}

}  // namespace groundtruth::definition
