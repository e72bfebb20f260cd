#pragma once
// The numbers of a clip in double-double, under one bound for the ask. Not installed.

#include <groundtruth/fast/surface_in_doubles.hpp>

namespace groundtruth::fast {

// Lemma clip-in-pairs (proofs-notes/rounding-of-forces.md, section 9): what clipped() is off by, of a force
// and a forward axis within 2^-94 force_size and 2^-90 of its length. Requires a clipping that
// SurfaceInDoubles has decided.
inline double clip_error(const ForceAsk& ask, const SurfaceInDoubles& decided, Clipping clipping) {
  const double of_disc =
      clipping == Clipping::onto_corner ? ask.friction * (1 + decided.corner_condition()) : ask.friction;
  return 0x1p-84 * (ask.force_size * (1 + of_disc));
}

// Force: of doubles or of pairs. Forward: gives the forward axis, which not every clipping needs. Formulas:
// lemma clipping-without-axes, as in ForceOnSurface (surface.hpp).
template <class Pair, class Force, class Forward>
class SurfaceInPairs {
 public:
  using Pairs = Pairs3<Pair>;

  SurfaceInPairs(const ForceAsk& ask, const Forward& forward, const Force& force)
      : ask_(ask),
        n_(ask.normal),
        friction_(ask.friction),
        brake_(ask.brake),
        forward_(forward),
        force_(force) {}

  // Loose.
  Pairs clipped(Clipping clipping) const {
    if (clipping == Clipping::onto_circle) return onto_circle();
    if (clipping == Clipping::onto_corner) return onto_corner();
    return brake_ == 0 ? projected_on_line() : corrected_to_band_edge();
  }

 private:
  Pairs corrected_to_band_edge() const {
    const auto& g = forward_();
    const Pair g_squared = dot<Pair>(g, g), along = dot<Pair>(g, force_);
    const Root<Pair> length = square_root(g_squared);
    const Pair edge = with_sign_of(along.high, product_of<Pair>(brake_, length.value));
    const Pair missing = quotient(Pair::loose_sum(edge, -along), g_squared, length.inverse * length.inverse);
    return Pairs::loose_sum(force_, product_of<Pairs>(missing, g));
  }
  Pairs projected_on_line() const {
    const auto& g = forward_();
    const Pair n_squared = dot<Pair>(n_, n_), area_squared = dot<Pair>(g, g) * n_squared;
    const Pair aside = quotient(dot<Pair>(g, cross<Pair>(n_, force_)), area_squared, 1 / area_squared.high);
    const Pair pressed = quotient(dot<Pair>(n_, force_), n_squared, 1 / n_squared.high);
    return Pairs::loose_sum(product_of<Pairs>(aside, cross<Pair>(g, n_)), product_of<Pairs>(pressed, n_));
  }
  Pairs onto_corner() const {
    const auto& g = forward_();
    const Pair n_squared = dot<Pair>(n_, n_), down = dot<Pair>(n_, force_),
               limit = product_of<Pair>(friction_, down);
    const Root<Pair> length = square_root(dot<Pair>(g, g));
    const Root<Pair> corner =
        square_root(determinant<Pair>(limit, limit, product_of<Pair>(brake_, brake_), n_squared).tidy());
    const double inverse = 1 / n_squared.high;
    const double along = dot_in_doubles(ask_.forward, ask_.force);
    const double across = dot_in_doubles(ask_.forward, cross_in_doubles(ask_.normal, ask_.force));
    const Pair ahead = with_sign_of(along, quotient(Pair(brake_), length.value, length.inverse));
    const Pair aside =
        with_sign_of(across, quotient(corner.value, length.value * n_squared, length.inverse * inverse));
    const Pair pressed = quotient(down, n_squared, inverse);
    return Pairs::loose_sum(
        Pairs::loose_sum(product_of<Pairs>(ahead, g), product_of<Pairs>(aside, cross<Pair>(g, n_))),
        product_of<Pairs>(pressed, n_));
  }
  Pairs onto_circle() const {
    const Pairs turning = cross<Pair>(n_, force_);
    const Pair down = dot<Pair>(n_, force_), n_squared = dot<Pair>(n_, n_);
    const Pair limit = product_of<Pair>(friction_, with_sign_of(down.high, down));
    const Root<Pair> turned = square_root(dot<Pair>(turning, turning));
    const Pair part = quotient(limit, turned.value, turned.inverse);
    const Pair pressed =
        product_of<Pair>(Pair::loose_sum(1, -part), quotient(down, n_squared, 1 / n_squared.high));
    return Pairs::loose_sum(product_of<Pairs>(part, force_), product_of<Pairs>(pressed, n_));
  }

  // Where it matters the sign in doubles is right: lemma slip-signs. Without a branch: nobody can foretell
  // it.
  static Pair with_sign_of(double sign, const Pair& x) {
    const double unit = std::copysign(1.0, sign + 0.0);
    return {unit * x.high, unit * x.low};
  }

  const ForceAsk& ask_;
  const Doubles3<Pair> n_;
  const double friction_, brake_;
  const Forward& forward_;
  const Force& force_;
};

}  // namespace groundtruth::fast
