#pragma once
// Numbers of a tower of real quadratic extensions, with exact sign: either plain (a Coefficient), or
// a + b sqrt(R) with R a positive integer and a, b of the tower whose radicands are all smaller than R.
// Products and sums of roots need no common context: the order of the radicands is the order of the tower.
//
// The form need not be unique (sqrt(8) and 2 sqrt(2) are kept apart), so equality is sign(x - y) == 0.
// A plain number is always recognised if the roots cancel term by term; otherwise it may still bear roots.

#include <memory>
#include <utility>

#include <groundtruth/definition/number.hpp>

namespace groundtruth::definition {

template <class Coefficient>
class Surd {
 public:
  Surd() = default;
  Surd(Coefficient plain) : plain_(std::move(plain)) {}  // NOLINT: a plain number is a surd
  Surd(int plain) : plain_(plain) {}                     // NOLINT

  // sqrt(radicand) as a root of its own, even if radicand is a square. Requires radicand > 0.
  static Surd root(Integer radicand) {
    return joined(0, 1, std::make_shared<const Integer>(std::move(radicand)));
  }

  bool is_plain() const { return !sum_; }
  // Requires is_plain().
  const Coefficient& plain() const { return plain_; }
  // The parts of a + b sqrt(R). Require !is_plain().
  const Surd& without_root() const { return sum_->a; }
  const Surd& root_factor() const { return sum_->b; }
  const Integer& radicand() const { return *sum_->radicand; }

  // -1, 0 or 1; by repeated squaring.
  int sign() const {
    if (is_plain()) return plain_.sign();
    const int a = without_root().sign();
    const int b = root_factor().sign();
    if (a * b >= 0) return a != 0 ? a : b;
    return a * norm().sign();
  }

  // Requires a value other than 0, and a Coefficient that can be divided.
  Surd inverse() const {
    if (is_plain()) return Coefficient(1) / plain_;
    const Surd n = norm();
    // (a + b sqrt R)(a - b sqrt R) = 0 though the first is not: then a = b sqrt R.
    if (n.sign() == 0) return (without_root() + without_root()).inverse();
    return joined(without_root(), -root_factor(), sum_->radicand) * n.inverse();
  }

  // The same sum with every coefficient c replaced by convert(c).
  template <class Other, class Convert>
  Surd<Other> converted(const Convert& convert) const {
    if (is_plain()) return convert(plain_);
    return Surd<Other>::joined(without_root().template converted<Other>(convert),
                               root_factor().template converted<Other>(convert), sum_->radicand);
  }

  friend Surd operator-(const Surd& x) {
    if (x.is_plain()) return Coefficient(-x.plain_);
    return joined(-x.without_root(), -x.root_factor(), x.sum_->radicand);
  }

  friend Surd operator+(const Surd& x, const Surd& y) {
    if (x.is_plain() && y.is_plain()) return Coefficient(x.plain_ + y.plain_);
    const int order = compare_height(x, y);
    if (order < 0) return y + x;
    if (order > 0) return joined(x.without_root() + y, x.root_factor(), x.sum_->radicand);
    return joined(x.without_root() + y.without_root(), x.root_factor() + y.root_factor(), x.sum_->radicand);
  }

  friend Surd operator-(const Surd& x, const Surd& y) {
    if (x.is_plain() && y.is_plain()) return Coefficient(x.plain_ - y.plain_);
    return x + -y;
  }

  friend Surd operator*(const Surd& x, const Coefficient& y) {
    if (x.is_plain()) return Coefficient(x.plain_ * y);
    return joined(x.without_root() * y, x.root_factor() * y, x.sum_->radicand);
  }

  friend Surd operator*(const Coefficient& x, const Surd& y) { return y * x; }

  friend Surd operator*(const Surd& x, const Surd& y) {
    if (y.is_plain()) return x * y.plain_;
    if (x.is_plain()) return y * x.plain_;
    const int order = compare_height(x, y);
    if (order < 0) return y * x;
    if (order > 0) return joined(x.without_root() * y, x.root_factor() * y, x.sum_->radicand);
    const Surd square = x.root_factor() * y.root_factor() * Coefficient(x.radicand());
    return joined(x.without_root() * y.without_root() + square,
                  x.without_root() * y.root_factor() + x.root_factor() * y.without_root(), x.sum_->radicand);
  }

  friend Surd operator/(const Surd& x, const Surd& y) { return x * y.inverse(); }

  friend bool operator<(const Surd& x, const Surd& y) { return (x - y).sign() < 0; }
  friend bool operator>(const Surd& x, const Surd& y) { return y < x; }
  friend bool operator<=(const Surd& x, const Surd& y) { return !(y < x); }
  friend bool operator>=(const Surd& x, const Surd& y) { return !(x < y); }

 private:
  template <class Other>
  friend class Surd;

  struct Sum {
    Surd a, b;
    std::shared_ptr<const Integer> radicand;
  };

  static Surd joined(Surd a, Surd b, std::shared_ptr<const Integer> radicand) {
    if (b.is_plain() && b.plain_.is_zero()) return a;
    Surd result;
    result.sum_ = std::make_shared<const Sum>(Sum{std::move(a), std::move(b), std::move(radicand)});
    return result;
  }

  // The sign of (largest radicand of x) - (largest radicand of y), plain numbers having none.
  static int compare_height(const Surd& x, const Surd& y) {
    if (x.is_plain() || y.is_plain()) return static_cast<int>(y.is_plain()) - static_cast<int>(x.is_plain());
    if (x.sum_->radicand == y.sum_->radicand) return 0;
    return x.radicand().compare(y.radicand());
  }

  // a^2 - b^2 R
  Surd norm() const {
    return without_root() * without_root() - root_factor() * root_factor() * Coefficient(radicand());
  }

  Coefficient plain_ = 0;
  std::shared_ptr<const Sum> sum_;
};

template <class Coefficient>
Surd<Coefficient> absolute(const Surd<Coefficient>& x) {
  return x.sign() < 0 ? -x : x;
}

}  // namespace groundtruth::definition
