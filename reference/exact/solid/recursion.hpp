#pragma once
// The recursive algorithm for lambda* on exact numbers, with the corrections of SPEC section 7. Which leaf is
// reported is not its business: see faces.hpp. Private to this folder; derivation:
// proofs-notes/entry-point.md.

#include <optional>
#include <vector>

#include <groundtruth/exact/arithmetic/root_sum.hpp>
#include <groundtruth/exact/solid/expression.hpp>

namespace groundtruth::exact {

// A half-space along a segment: Delta(x(lambda)) = at_origin + lambda slope.
template <typename Number>
struct Course {
  Number at_origin;
  Rational slope;

  Number at(const Number& lambda) const {
    const Number value = at_origin + lambda * slope;
    return value;
  }
  // Where Delta is zero. Requires slope != 0.
  Number crossing() const {
    const Rational minus_slope = -slope;
    const Number value = at_origin / minus_slope;
    return value;
  }
};

template <typename Number>
bool less(const Number& left, const Number& right) {
  return sign(Number(right - left)) > 0;
}

template <typename Number>
class Recursion {
 public:
  // The expression's leaves are places in `courses`; the range ends at `last`.
  Recursion(const Expression& expression, const std::vector<Course<Number>>& courses, Number last)
      : expression_(expression), courses_(courses), last_(std::move(last)), remembered_(expression.size()) {}

  // The smallest lambda in [first, last] at which the expression holds.
  std::optional<Number> entry(const Number& first) { return entry(0, first); }

 private:
  // What a node answered when it was last asked.
  struct Remembered {
    Number first;
    std::optional<Number> found;
  };

  // Asked from further on, but not beyond what was found, a node gives the same answer; without this,
  // restarts multiply from level to level.
  std::optional<Number> entry(std::size_t at, const Number& first) {
    std::optional<Remembered>& before = remembered_[at];
    const bool same_answer =
        before && !less(first, before->first) && (!before->found || !less(*before->found, first));
    if (same_answer) return before->found;
    std::optional<Number> found = computed_entry(at, first);
    before = Remembered{first, found};
    return found;
  }

  std::optional<Number> computed_entry(std::size_t at, const Number& first) {
    switch (expression_[at].operation) {
      case Operation::everything:
        return first;
      case Operation::nothing:
        return std::nullopt;
      case Operation::leaf:
        return half_space_entry(courses_[expression_[at].leaf], first);
      case Operation::united:
        return union_entry(at, first);
      case Operation::intersected:
        return intersection_entry(at, first);
    }
    return std::nullopt;
  }

  std::optional<Number> half_space_entry(const Course<Number>& course, const Number& first) const {
    if (sign(course.at(first)) <= 0) return first;
    if (sign(course.slope) >= 0) return std::nullopt;
    const Number crossing = course.crossing();
    if (less(last_, crossing)) return std::nullopt;
    return crossing;
  }

  std::optional<Number> union_entry(std::size_t at, const Number& first) {
    std::optional<Number> best;
    for (std::size_t operand = at + 1; operand < expression_[at].end; operand = expression_[operand].end) {
      const std::optional<Number> found = entry(operand, first);
      if (found && (!best || less(*found, *best))) best = found;
      if (best && !less(first, *best)) return best;
    }
    return best;
  }

  // Moves lambda up to where the next operand is entered until none moves it any more; at most one round a
  // leaf, and two more (lemma restart-loop-ends).
  std::optional<Number> intersection_entry(std::size_t at, const Number& first) {
    Number lambda = first;
    bool moved = true;
    while (moved) {
      moved = false;
      for (std::size_t operand = at + 1; operand < expression_[at].end; operand = expression_[operand].end) {
        const std::optional<Number> found = entry(operand, lambda);
        if (!found) return std::nullopt;
        if (less(lambda, *found)) {
          lambda = *found;
          moved = true;
        }
      }
    }
    return lambda;
  }

  const Expression& expression_;
  const std::vector<Course<Number>>& courses_;
  const Number last_;
  std::vector<std::optional<Remembered>> remembered_;  // by node
};

}  // namespace groundtruth::exact
