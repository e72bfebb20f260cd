#pragma once
// The solid as it looks from one of its points: leaves whose plane passes there, the others replaced by
// everything or nothing and simplified away (SPEC section 3).

#include <groundtruth/tiers/naive/segment.hpp>

namespace groundtruth::tiers::naive {

template <class Real>
struct Local {
  Operation operation = Operation::nothing;
  std::size_t standing = 0;  // of a half-space: its place among the leaves that stand
  std::vector<Local> operands;
};

// `standing` receives the leaves that are left, in ascending order.
template <class Real>
Local<Real> local_shape(const Solid<Real>& solid, std::size_t node, const Segment<Real>& segment,
                        const Place<Real>& place, std::vector<const Node<Real>*>& standing) {
  const Node<Real>& here = solid[node];
  if (here.operation == Operation::half_space) {
    const Side side = segment.side(here, place);
    if (side == Side::inside) return {Operation::everything, 0, {}};
    if (side == Side::outside) return {Operation::nothing, 0, {}};
    standing.push_back(&here);
    return {Operation::half_space, standing.size() - 1, {}};
  }
  if (here.operation == Operation::everything || here.operation == Operation::nothing)
    return {here.operation, 0, {}};
  const bool is_union = here.operation == Operation::union_of;
  const Operation swallows = is_union ? Operation::everything : Operation::nothing;
  const Operation vanishes = is_union ? Operation::nothing : Operation::everything;
  const std::size_t stood_before = standing.size();
  Local<Real> local{here.operation, 0, {}};
  for (std::size_t operand = node + 1; operand < here.end; operand = solid[operand].end) {
    Local<Real> below = local_shape(solid, operand, segment, place, standing);
    if (below.operation == swallows) {
      standing.resize(stood_before);
      return {swallows, 0, {}};
    }
    if (below.operation != vanishes) local.operands.push_back(std::move(below));
  }
  if (local.operands.empty()) return {vanishes, 0, {}};
  return local;
}

// A standing leaf's half-space at a direction from the point: known to hold it or not, or left open.
enum class Value { in, out, open };

// What is left of the local shape when some leaves are given values, and does leaf `wanted` stand in it?
struct Reduced {
  Operation operation = Operation::nothing;  // half_space: neither everything nor nothing
  bool has_wanted = false;
};

template <class Real>
Reduced reduced(const Local<Real>& local, const std::vector<Value>& values, std::size_t wanted) {
  if (local.operation == Operation::half_space) {
    const Value value = values[local.standing];
    if (value == Value::open) return {Operation::half_space, local.standing == wanted};
    return {value == Value::in ? Operation::everything : Operation::nothing, false};
  }
  if (local.operation == Operation::everything || local.operation == Operation::nothing)
    return {local.operation, false};
  const bool is_union = local.operation == Operation::union_of;
  const Operation swallows = is_union ? Operation::everything : Operation::nothing;
  Reduced result{is_union ? Operation::nothing : Operation::everything, false};
  for (const Local<Real>& operand : local.operands) {
    const Reduced below = reduced(operand, values, wanted);
    if (below.operation == swallows) return {swallows, false};
    if (below.operation != Operation::half_space) continue;
    result.operation = Operation::half_space;
    result.has_wanted = result.has_wanted || below.has_wanted;
  }
  return result;
}

}  // namespace groundtruth::tiers::naive
