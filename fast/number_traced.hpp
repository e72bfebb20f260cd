#pragma once
// Double-doubles that know whether they are exact: then no bound is needed to round one that is a tie (lemma
// exact-pairs, proofs-notes/rounding-of-forces.md, section 2). Not installed.

#include <groundtruth/fast/number_counted.hpp>

namespace groundtruth::fast {

// The values are those of Pair, operation by operation, so that bounds for pairs hold.
struct TracedPair {
  double high = 0;
  double low = 0;
  bool is_exact = true;  // certainly, of the operations on what it is made from

  TracedPair() = default;
  TracedPair(double x) : high(x) {}  // implicit: nothing is lost
  TracedPair(const Pair& pair, bool exact) : high(pair.high), low(pair.low), is_exact(exact) {}

  static TracedPair sum(double a, double b) { return {Pair::sum(a, b), true}; }
  static TracedPair product(double a, double b) { return {Pair::product(a, b), keeps_all(a, b)}; }

  static TracedPair loose_sum(const TracedPair& a, const TracedPair& b) {
    const Pair lows = Pair::sum(a.low, b.low), more = Pair::sum(Pair::sum(a.high, b.high).low, lows.high);
    const bool loses_nothing = lows.low == 0 && more.low == 0;
    return {Pair::loose_sum(a.pair(), b.pair()), a.is_exact && b.is_exact && loses_nothing};
  }
  static TracedPair loose_product(const TracedPair& a, const TracedPair& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const Pair outer = Pair::product(a.high, b.low), inner = Pair::product(a.low, b.high);
    const Pair cross = Pair::sum(outer.high, inner.high);
    const Pair more = Pair::sum(Pair::product(a.high, b.high).low, cross.high);
    const bool loses_nothing = outer.low == 0 && inner.low == 0 && cross.low == 0 && more.low == 0 &&
                               (a.low == 0 || b.low == 0) && keeps_all(a.high, b.high) &&
                               keeps_all(a.high, b.low) && keeps_all(a.low, b.high);
    return {Pair::loose_product(a.pair(), b.pair()), a.is_exact && b.is_exact && loses_nothing};
  }
  TracedPair tidy() const {
    return {pair().tidy(), is_exact && pair().tidy().low == Pair::sum(high, low).low};
  }

  bool is_zero() const { return is_exact && high == 0 && low == 0; }

  explicit operator double() const { return high; }
  friend TracedPair operator+(const TracedPair& a, const TracedPair& b) { return loose_sum(a, b).tidy(); }
  friend TracedPair operator-(const TracedPair& a) { return {-a.pair(), a.is_exact}; }
  friend TracedPair operator-(const TracedPair& a, const TracedPair& b) { return a + -b; }
  friend TracedPair operator*(const TracedPair& a, const TracedPair& b) { return loose_product(a, b).tidy(); }
  friend TracedPair operator/(const TracedPair& a, const TracedPair& b) {
    const TracedPair quotient{a.pair() / b.pair(), true};
    return {quotient.pair(), (quotient * b - a).is_zero()};
  }
  friend TracedPair sqrt(const TracedPair& a) {
    const TracedPair root{sqrt(a.pair()), true};
    return {root.pair(), (root * root - a).is_zero()};
  }

 private:
  Pair pair() const { return {high, low}; }
  // Of a product: nothing underflows.
  static bool keeps_all(double a, double b) { return a == 0 || b == 0 || std::abs(a * b) >= 0x1p-900; }
};

// As for other pairs; and any number that is exact.
template <int n>
std::optional<double> nearest_double(const Counted<TracedPair, n>& a) {
  const Pair value{a.value.high, a.value.low};
  const double nearest = value.high + value.low;
  if (a.value.is_exact && std::isfinite(a.size) && std::abs(nearest) >= 0x1p-900 && std::isfinite(nearest))
    return nearest;
  return nearest_double(Counted<Pair, n>{value, a.size});
}

}  // namespace groundtruth::fast
