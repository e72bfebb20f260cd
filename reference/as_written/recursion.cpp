#include <groundtruth/as_written/recursion.hpp>

#include <algorithm>

namespace groundtruth::as_written {
namespace {

constexpr std::size_t million = 1'000'000;

class Recursion {
 public:
  Recursion(const Expression& expression, const Segment& segment, const Errata& errata)
      : expression_(expression),
        segment_(segment),
        errata_(errata),
        replacements_left_(std::max(million, (expression.size() + 2) * (expression.size() + 2))) {}

  std::optional<Reached> phi(double lambda_1, double lambda_2, std::size_t node) {
    switch (expression_[node].operation) {
      case Operation::everything:
        return Reached{lambda_1, nullptr};
      case Operation::nothing:
        return miss(lambda_2);
      case Operation::half_space:
        return errata_.has(Erratum::normal_by_order)
                   ? half_space_in_part(lambda_1, lambda_2, expression_[node])
                   : half_space_in_whole(lambda_1, lambda_2, expression_[node]);
      case Operation::union_of:
        return phi_of_union(lambda_1, lambda_2, node);
      case Operation::intersection_of:
        return phi_of_intersection(lambda_1, lambda_2, node);
    }
    return miss(lambda_2);
  }

 private:
  std::optional<Reached> miss(double lambda_2) const {
    if (errata_.has(Erratum::miss_is_plus_1000)) {
      return Reached{lambda_2 + 1000, nullptr};
    }
    return std::nullopt;
  }

  std::optional<Reached> half_space_in_part(double lambda_1, double lambda_2, const Node& face) const {
    const double mu_1 = segment_.distance(face.half_space, lambda_1);
    const double mu_2 = segment_.distance(face.half_space, lambda_2);
    if (mu_1 < 0) {
      return Reached{lambda_1, nullptr};
    }
    if (mu_1 == 0) {
      return Reached{lambda_1, &face};
    }
    if (mu_1 > 0 && mu_2 <= 0) {
      if (const auto lambda = crossing(lambda_1, lambda_2, mu_1, mu_2)) {
        return Reached{*lambda, &face};
      }
    }
    return miss(lambda_2);
  }

  std::optional<Reached> half_space_in_whole(double lambda_1, double lambda_2, const Node& face) const {
    switch (segment_.side(face.half_space, lambda_1)) {
      case Side::inside:
        return Reached{lambda_1, nullptr};
      case Side::on:
        return Reached{lambda_1, &face};
      case Side::outside:
        const std::optional<double> lambda = segment_.entry(face.half_space);
        return lambda && lambda_1 < *lambda && *lambda <= lambda_2 ? Reached{*lambda, &face} : miss(lambda_2);
    }
    return miss(lambda_2);
  }

  std::optional<Reached> phi_of_union(double lambda_1, double lambda_2, std::size_t node) {
    std::optional<Reached> best = miss(lambda_2);
    for (std::size_t operand = node + 1; operand != expression_[node].end;
         operand = expression_[operand].end) {
      const double end = best ? std::min(best->lambda, lambda_2) : lambda_2;
      const std::optional<Reached> found = phi(lambda_1, end, operand);
      if (found && (!best || found->lambda < best->lambda)) {
        best = found;
      }
    }
    return best;
  }

  std::optional<Reached> phi_of_intersection(double lambda_1, double lambda_2, std::size_t node) {
    const std::size_t end = expression_[node].end;
    std::size_t replacements_left = end - node + 2;
    Reached reached{lambda_1, nullptr};
    // The operand that was last to replace is satisfied: asking it again could only repeat its rounding.
    std::size_t last_to_replace = end;
    while (true) {
      for (std::size_t operand = node + 1; operand != end; operand = expression_[operand].end) {
        if (operand == last_to_replace) {
          return reached;
        }
        const std::optional<Reached> found = phi(reached.lambda, lambda_2, operand);
        if (!found) {
          return std::nullopt;
        }
        if (found->lambda > reached.lambda ||
            (found->lambda == reached.lambda && found->face && !reached.face)) {
          reached = *found;
          last_to_replace = operand;
          if (reached.lambda > lambda_2 || !take_one(replacements_left) || !take_one(replacements_left_)) {
            return reached;
          }
        }
      }
      if (last_to_replace == end || is_single_pass(node)) {
        return reached;
      }
    }
  }

  static bool take_one(std::size_t& left) {
    if (left == 0) {
      return false;
    }
    --left;
    return true;
  }

  bool is_single_pass(std::size_t node) const {
    if (!errata_.has(Erratum::single_pass_intersection)) {
      return false;
    }
    for (std::size_t operand = node + 1; operand != expression_[node].end;
         operand = expression_[operand].end) {
      const Operation operation = expression_[operand].operation;
      if (operation == Operation::union_of || operation == Operation::intersection_of) {
        return false;
      }
    }
    return true;
  }

  const Expression& expression_;
  const Segment& segment_;
  const Errata& errata_;
  std::size_t replacements_left_;
};

}  // namespace

std::optional<Reached> first_reached(const Expression& expression, const Segment& segment,
                                     const Errata& errata) {
  return Recursion(expression, segment, errata).phi(segment.first(), segment.last(), 0);
}

}  // namespace groundtruth::as_written
