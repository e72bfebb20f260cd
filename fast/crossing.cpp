#include <groundtruth/fast/crossing.hpp>

#include <cmath>

#include <groundtruth/fast/exact_stage/entry.hpp>

namespace groundtruth::fast {

namespace {

constexpr double unit = 0x1p-53;

// An unevaluated sum: high = fl(high + low).
struct Pair {
  double high;
  double low;
};

Pair two_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// Requires |a| >= |b| or a = 0.
Pair fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// Exact (Dekker) unless a part under- or overflows.
Pair two_product(double a, double b) {
#ifdef __FMA__
  const double product = a * b;
  return {product, __builtin_fma(a, b, -product)};
#else
  constexpr double splitter = 0x1p27 + 1;
  const double a_scaled = splitter * a, a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
  const double b_scaled = splitter * b, b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
  const double product = a * b;
  return {product, a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)};
#endif
}

// Delta at x, and the sum of its terms' magnitudes.
struct Delta {
  Pair value;
  double size;
};

// Off by at most 32 u^2 size + 2^-1060.
Delta delta(const HalfSpace& leaf, const Vector& x) {
  const Pair p0 = two_product(leaf.normal[0], x[0]);
  const Pair p1 = two_product(leaf.normal[1], x[1]);
  const Pair p2 = two_product(leaf.normal[2], x[2]);
  const Pair s0 = two_sum(p0.high, p1.high);
  const Pair s1 = two_sum(s0.high, p2.high);
  const Pair s2 = two_sum(s1.high, -leaf.offset);
  const double rest = ((p0.low + p1.low) + p2.low) + ((s0.low + s1.low) + s2.low);
  return {two_sum(s2.high, rest),
          std::abs(p0.high) + std::abs(p1.high) + std::abs(p2.high) + std::abs(leaf.offset)};
}

}  // namespace

std::optional<double> rounded_crossing(const HalfSpace& leaf, const EntryAsk& ask) {
  const Delta a = delta(leaf, ask.from), b = delta(leaf, ask.to);
  const Pair w_high = two_sum(a.value.high, -b.value.high);
  const Pair w = two_sum(w_high.high, w_high.low + (a.value.low - b.value.low));

  const double q0 = a.value.high / w.high;
  const Pair product = two_product(q0, w.high);
  const double remainder = ((a.value.high - product.high) - product.low) + (a.value.low - q0 * w.low);
  const Pair lambda = fast_two_sum(q0, remainder / w.high);

  const double size = a.size + b.size, magnitude = std::abs(lambda.high);
  const double error = 128 * unit * unit * (size / std::abs(w.high)) * (1 + 2 * magnitude) +
                       32 * unit * unit * magnitude + 0x1p-1000 * (1 + 2 * magnitude) / std::abs(w.high);
  const bool is_in_range = size < 0x1p900 && magnitude > 0x1p-900 && magnitude < 0x1p900;
  if (!is_in_range || lambda.high + (lambda.low + error) != lambda.high + (lambda.low - error))
    return std::nullopt;
  return lambda.high;
}

RoundedLambda correctly_rounded_crossing(const HalfSpace& leaf, const EntryAsk& ask) {
  if (const auto lambda = rounded_crossing(leaf, ask)) return {*lambda, Stage::double_pair};
  return {exact_stage::crossing(leaf, ask), Stage::exact};
}

}  // namespace groundtruth::fast
