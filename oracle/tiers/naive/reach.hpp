#pragma once
// Phi's parameter, by recursion over the expression, word by word.

#include <groundtruth/tiers/naive/segment.hpp>

namespace groundtruth::tiers::naive {

// The first place at or after `from` that lies in the node's solid. An intersection asks its operands round
// and round until none moves the place on: each move goes to a later crossing, of which there are as many as
// leaves.
template <class Real>
std::optional<Place<Real>> first_reached(const Solid<Real>& solid, std::size_t node,
                                         const Segment<Real>& segment, const Place<Real>& from) {
  const Node<Real>& here = solid[node];
  switch (here.operation) {
    case Operation::everything:
      return from;
    case Operation::nothing:
      return std::nullopt;
    case Operation::half_space:
      return segment.reach(here, from);
    case Operation::union_of: {
      std::optional<Place<Real>> best;
      for (std::size_t operand = node + 1; operand < here.end; operand = solid[operand].end) {
        const auto found = first_reached(solid, operand, segment, from);
        if (found && (!best || is_later(*best, *found))) best = found;
        if (best && is_known_to_equal(*best, from)) return best;
      }
      return best;
    }
    case Operation::intersection_of: {
      Place<Real> place = from;
      for (bool moved = true; moved;) {
        moved = false;
        for (std::size_t operand = node + 1; operand < here.end; operand = solid[operand].end) {
          const auto found = first_reached(solid, operand, segment, place);
          if (!found) return std::nullopt;
          if (!is_later(*found, place)) continue;
          place = *found;
          moved = true;
        }
      }
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace groundtruth::tiers::naive
