#include <groundtruth/fast/exact_stage/clip.hpp>

#include <string>

#include <groundtruth/fast/exact_stage/rounding.hpp>

namespace groundtruth::fast::exact_stage {

namespace {

Normal<Dyadic> as_dyadics(const Vector& v) { return {v[0], v[1], v[2]}; }

// In the surface's axes, each as long as it is here:
//   along  = F'_x r,      axis (-n_z, 0, n_x), of length r
//   across = F'_y r |n|,  axis (-n_x n_y, r^2, -n_y n_z), of length r |n|
//   down   = F'_z |n|,    axis -n
// where F is the force times the grasp's denominator, and so is the brake.
class ForceOnSurface {
 public:
  explicit ForceOnSurface(const Grasp& grasp)
      : grasp_(grasp),
        brake_(Dyadic(grasp.brake) * grasp.denominator),
        r_squared_(square(n()[0]) + square(n()[2])),
        n_squared_(r_squared_ + square(n()[1])),
        along_axis_{-n()[2], {}, n()[0]},
        across_axis_{-(n()[0] * n()[1]), r_squared_, -(n()[1] * n()[2])},
        along_(dot(along_axis_, grasp.force_in_wheel)),
        across_(dot(across_axis_, grasp.force_in_wheel)),
        down_(-dot(n(), grasp.force_in_wheel)),
        disc_(square(Dyadic(grasp.friction) * down_)),
        band_(square(brake_) * n_squared_),
        corner_(disc_ - band_) {}

  ClippedForce clipped() const {
    if (is_within_border()) return {Grip::stick, as_it_is(), 1.0};
    if (corner_.sign() > 0 && is_between_corners()) return onto_band_edge();
    if (corner_.sign() > 0 && is_beside_corner()) return onto_corner();
    return onto_circle();
  }

 private:
  const Normal<Dyadic>& n() const { return grasp_.normal_in_wheel; }
  static bool at_most(const Dyadic& a, const Dyadic& b) { return (a - b).sign() <= 0; }

  // With mu^2 N^2 |n|^2 = disc_ and B^2 |n|^2 = band_.
  bool is_within_border() const {
    return at_most(square(along_), square(brake_) * r_squared_) &&
           at_most(square(along_) * n_squared_ + square(across_), disc_ * r_squared_);
  }
  bool is_between_corners() const { return at_most(square(across_), r_squared_ * corner_); }
  bool is_beside_corner() const { return at_most(square(brake_ * across_), square(along_) * corner_); }

  SurdVector as_it_is() const {
    SurdVector force{{}, grasp_.denominator, {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      force.numerators[axis].rational = grasp_.force_in_wheel[axis];
    return force;
  }

  // The slips H of SPEC section 4, cases 1 to 3.
  ClippedForce onto_band_edge() const {
    const Dyadic surplus = r_squared_ * n_squared_;
    SurdVector force{{}, surplus * grasp_.denominator, {r_squared_, {}}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      force.numerators[axis] = {
          across_ * across_axis_[axis] - down_part(axis, r_squared_), edge_part(axis), {}};
    return {Grip::slip, force, surplus};
  }
  ClippedForce onto_corner() const {
    const Dyadic surplus = r_squared_ * n_squared_;
    SurdVector force{{}, surplus * grasp_.denominator, {r_squared_, corner_ * r_squared_}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      force.numerators[axis] = {-down_part(axis, r_squared_), edge_part(axis),
                                with_sign_of(across_, across_axis_[axis])};
    return {Grip::slip, force, surplus};
  }
  ClippedForce onto_circle() const {
    const Dyadic length_squared = (square(along_) * n_squared_ + square(across_)) * r_squared_;
    const Dyadic limit = Dyadic(grasp_.friction) * magnitude(down_);
    const Dyadic surplus = length_squared * n_squared_;
    SurdVector force{{}, surplus * grasp_.denominator, {length_squared, {}}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      force.numerators[axis] = {
          -down_part(axis, length_squared),
          limit * (along_ * n_squared_ * along_axis_[axis] + across_ * across_axis_[axis]),
          {}};
    return {Grip::slip, force, surplus};
  }

  Dyadic down_part(std::size_t axis, const Dyadic& square_under_root) const {
    return down_ * square_under_root * n()[axis];
  }
  Dyadic edge_part(std::size_t axis) const {
    return with_sign_of(along_, brake_ * n_squared_ * along_axis_[axis]);
  }
  static Dyadic with_sign_of(const Dyadic& sign, const Dyadic& x) {
    return sign.sign() > 0 ? x : sign.sign() < 0 ? -x : Dyadic();
  }

  const Grasp& grasp_;
  const Dyadic brake_;
  const Dyadic r_squared_;
  const Dyadic n_squared_;
  const Normal<Dyadic> along_axis_;
  const Normal<Dyadic> across_axis_;
  const Dyadic along_;
  const Dyadic across_;
  const Dyadic down_;
  const Dyadic disc_;    // mu^2 N^2 |n|^2
  const Dyadic band_;    // B^2 |n|^2
  const Dyadic corner_;  // s^2 |n|^2
};

}  // namespace

std::variant<Vector, Refusal> nearest_doubles(const SurdVector& v, const char* quantity) {
  Vector rounded{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto component = nearest_double(v.numerators[axis], v.roots, v.denominator);
    if (!component)
      return Refusal{std::string(quantity) + "[" + std::to_string(axis) + "] leaves the range of doubles"};
    rounded[axis] = *component;
  }
  return rounded;
}

bool is_upright(const Normal<Dyadic>& normal_in_wheel, double min_uprightness) {
  const auto& [x, y, z] = normal_in_wheel;
  if (z.sign() >= 0) return false;
  return (square(z) - square(Dyadic(min_uprightness)) * (square(x) + square(y))).sign() >= 0;
}

ClippedForce clip_force(const Grasp& grasp) { return ForceOnSurface(grasp).clipped(); }

ClipAnswer clip(const ClipAsk& ask) {
  const Normal<Dyadic> normal = as_dyadics(ask.normal_in_wheel);
  if (!is_upright(normal, ask.min_uprightness)) return TooSteep{};
  const ClippedForce clipped =
      clip_force({normal, as_dyadics(ask.force_in_wheel), 1.0, ask.friction, ask.brake});
  const auto force = nearest_doubles(clipped.force_in_wheel, "force");
  if (const auto* refusal = std::get_if<Refusal>(&force)) return *refusal;
  return Clipped{clipped.grip, std::get<Vector>(force)};
}

}  // namespace groundtruth::fast::exact_stage
