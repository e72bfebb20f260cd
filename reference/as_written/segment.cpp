#include <groundtruth/as_written/segment.hpp>
#include <groundtruth/as_written/vector_algebra.hpp>

#include <algorithm>
#include <cmath>

namespace groundtruth::as_written {
namespace {

Side side_of_distance(double distance) {
  if (distance < 0) {
    return Side::inside;
  }
  return distance == 0 ? Side::on : Side::outside;
}

double distance_of(const Vector& point, const HalfSpace& half_space) {
  return dot(half_space.normal, point) - half_space.offset;
}

}  // namespace

std::optional<double> crossing(double lambda_1, double lambda_2, double mu_1, double mu_2) {
  if (mu_1 == 0) {
    return lambda_1;
  }
  if (mu_2 == 0) {
    return lambda_2;
  }
  // The product first: the quotient of exact distances is then rounded once, so that proportional planes
  // agree.
  const double lambda = lambda_1 - mu_1 * (lambda_2 - lambda_1) / (mu_2 - mu_1);
  if (std::isnan(lambda)) {
    return std::nullopt;
  }
  return std::clamp(lambda, lambda_1, lambda_2);
}

Segment::Segment(const EntryAsk& ask)
    : from_(ask.from),
      direction_(minus(ask.to, ask.from)),
      first_(ask.lambda_first),
      last_(ask.lambda_last),
      at_first_(at(first_)),
      at_last_(at(last_)) {}

Vector Segment::at(double lambda) const { return plus(from_, times(lambda, direction_)); }

double Segment::distance(const HalfSpace& half_space, double lambda) const {
  return distance_of(at(lambda), half_space);
}

std::optional<double> Segment::entry(const HalfSpace& half_space) const {
  const double mu_1 = distance_of(at_first_, half_space);
  const double mu_2 = distance_of(at_last_, half_space);
  if (mu_1 > 0 && mu_2 <= 0) {
    return crossing(first_, last_, mu_1, mu_2);
  }
  return std::nullopt;
}

Side Segment::side(const HalfSpace& half_space, double lambda) const {
  const double mu_1 = distance_of(at_first_, half_space);
  const double mu_2 = distance_of(at_last_, half_space);
  const Side at_first = side_of_distance(mu_1);
  const Side at_last = side_of_distance(mu_2);
  if (at_first == at_last) {
    return at_first;
  }
  // A crossing that rounds to the start must not make a face of a plane that is only left there.
  if (lambda == first_ && at_first != Side::outside) {
    return at_first;
  }
  const std::optional<double> crossed = crossing(first_, last_, mu_1, mu_2);
  if (!crossed) {
    return Side::outside;
  }
  if (lambda == *crossed) {
    return Side::on;
  }
  return lambda < *crossed ? at_first : at_last;
}

bool Segment::lies_in(const Expression& expression, std::size_t node, double lambda) const {
  switch (const Node& here = expression[node]; here.operation) {
    case Operation::everything:
      return true;
    case Operation::nothing:
      return false;
    case Operation::half_space:
      return side(here.half_space, lambda) != Side::outside;
    case Operation::union_of:
    case Operation::intersection_of:
      const bool deciding = here.operation == Operation::union_of;
      for (std::size_t operand = node + 1; operand != here.end; operand = expression[operand].end) {
        if (lies_in(expression, operand, lambda) == deciding) {
          return deciding;
        }
      }
      return !deciding;
  }
  return false;
}

}  // namespace groundtruth::as_written
