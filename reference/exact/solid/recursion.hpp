#pragma once
// The recursive algorithm for lambda* on exact numbers, with the corrections of SPEC section 7. Which leaf is
// reported is not its business: see faces.hpp. Private to this folder; derivation:
// proofs-notes/entry-point.md.

#include <optional>
#include <vector>

#include <groundtruth/exact/arithmetic/root_sum.hpp>
#include <groundtruth/exact/solid/expression.hpp>

namespace groundtruth::exact {

// A half-space along a segment: Delta(x(lambda)) = at_origin + lambda slope. Its normal is not zero.
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
  // The expression's leaves are places in `courses`.
  Recursion(const Expression& expression, const std::vector<Course<Number>>& courses)
      : expression_(expression), courses_(courses) {}

  // The smallest lambda in [first, last] at which the expression holds.
  std::optional<Number> entry(const Number& first, const Number& last) const { return entry(0, first, last); }

 private:
  std::optional<Number> entry(std::size_t at, const Number& first, const Number& last) const {
    switch (expression_[at].operation) {
      case Operation::everything:
        return first;
      case Operation::nothing:
        return std::nullopt;
      case Operation::leaf:
        return half_space_entry(courses_[expression_[at].leaf], first, last);
      case Operation::united:
        return union_entry(at, first, last);
      case Operation::intersected:
        return intersection_entry(at, first, last);
    }
    return std::nullopt;
  }

  static std::optional<Number> half_space_entry(const Course<Number>& course, const Number& first,
                                                const Number& last) {
    if (sign(course.at(first)) <= 0) return first;
    if (sign(course.slope) >= 0) return std::nullopt;
    const Number crossing = course.crossing();
    if (less(last, crossing)) return std::nullopt;
    return crossing;
  }

  std::optional<Number> union_entry(std::size_t at, const Number& first, const Number& last) const {
    std::optional<Number> best;
    for (std::size_t operand = at + 1; operand < expression_[at].end; operand = expression_[operand].end) {
      const std::optional<Number> found = entry(operand, first, best ? *best : last);
      if (found && (!best || less(*found, *best))) best = found;
      if (best && !less(first, *best)) return best;
    }
    return best;
  }

  // Moves lambda up to where the next operand is entered until none moves it any more; at most one round a
  // leaf, and two more (lemma restart-loop-ends).
  std::optional<Number> intersection_entry(std::size_t at, const Number& first, const Number& last) const {
    Number lambda = first;
    bool moved = true;
    while (moved) {
      moved = false;
      for (std::size_t operand = at + 1; operand < expression_[at].end; operand = expression_[operand].end) {
        const std::optional<Number> found = entry(operand, lambda, last);
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
};

}  // namespace groundtruth::exact
