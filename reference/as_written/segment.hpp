#pragma once
// A segment among half-spaces, in plain doubles.

#include <cstddef>
#include <optional>

#include <groundtruth/as_written/expression.hpp>
#include <groundtruth/problem/ask.hpp>

namespace groundtruth::as_written {

enum class Side { inside, on, outside };

// x(lambda) = from + lambda (to - from) for lambda in [first, last]. Where an overflow leaves no number, a
// point lies outside and a plane is not crossed.
class Segment {
 public:
  explicit Segment(const EntryAsk& ask);

  double first() const { return first_; }
  double last() const { return last_; }

  Vector at(double lambda) const;

  // n . x(lambda) - d, rounded at every operation.
  double distance(const HalfSpace& half_space, double lambda) const;

  // Where the half-space is entered, if it is outside at first() and not at last(). Computed from these two
  // ends only, whatever part of the range is asked about: planes that the segment crosses at one point then
  // share every bit of lambda, if the distances are exact.
  std::optional<double> entry(const HalfSpace& half_space) const;

  // The side of x(lambda), by comparing lambda with the one parameter at which the plane is crossed.
  Side side(const HalfSpace& half_space, double lambda) const;

  // Is x(lambda) in the expression, by side()?
  bool lies_in(const Expression& expression, std::size_t node, double lambda) const;

 private:
  Vector from_;
  Vector direction_;
  double first_;
  double last_;
  Vector at_first_;
  Vector at_last_;
};

// The source's lambda_1 - mu_1 (lambda_2 - lambda_1) / (mu_2 - mu_1), kept within [lambda_1, lambda_2];
// nothing if it is not a number. Requires mu_1 and mu_2 on different sides of 0, or one of them 0.
std::optional<double> crossing(double lambda_1, double lambda_2, double mu_1, double mu_2);

}  // namespace groundtruth::as_written
