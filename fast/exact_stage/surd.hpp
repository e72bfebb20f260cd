#pragma once
// Numbers a + b sqrt(A) + c sqrt(D) over two given roots: what a slip asks about. Not installed.

#include <groundtruth/fast/exact_stage/dyadic.hpp>

namespace groundtruth::fast::exact_stage {

// Both >= 0; a root that is not needed is 0.
struct Radicands {
  Dyadic first;
  Dyadic second;
};

struct Surd {
  Dyadic rational;
  Dyadic of_first;   // times sqrt(first)
  Dyadic of_second;  // times sqrt(second)

  friend Surd operator+(const Surd& x, const Surd& y) {
    return {x.rational + y.rational, x.of_first + y.of_first, x.of_second + y.of_second};
  }
  friend Surd operator-(const Surd& x) { return {-x.rational, -x.of_first, -x.of_second}; }
  friend Surd operator-(const Surd& x, const Surd& y) {
    return {x.rational - y.rational, x.of_first - y.of_first, x.of_second - y.of_second};
  }
  friend Surd operator*(const Surd& x, const Dyadic& factor) {
    return {x.rational * factor, x.of_first * factor, x.of_second * factor};
  }
};

// The sign of a + b sqrt(radicand).
inline int sign_with_root(const Dyadic& a, const Dyadic& b, const Dyadic& radicand) {
  const int sign_a = a.sign(), sign_root = b.sign() * radicand.sign();
  if (sign_a * sign_root >= 0) return sign_a != 0 ? sign_a : sign_root;
  return sign_a * (square(a) - square(b) * radicand).sign();
}

// Squares until no root is left: the sum of two terms of opposite signs has the sign of the one whose square
// is greater.
inline int sign(const Surd& x, const Radicands& roots) {
  const auto& [a, b, c] = x;
  const int sign_rest = sign_with_root(a, b, roots.first), sign_root = c.sign() * roots.second.sign();
  if (sign_rest * sign_root >= 0) return sign_rest != 0 ? sign_rest : sign_root;
  const Dyadic squares = square(a) + square(b) * roots.first - square(c) * roots.second;
  return sign_rest * sign_with_root(squares, (a * b).scaled(1), roots.first);
}

}  // namespace groundtruth::fast::exact_stage
