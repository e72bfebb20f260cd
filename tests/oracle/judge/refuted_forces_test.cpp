// With a relative tolerance, a force that no border within it bears is rejected. Checked by the border's own
// inequalities on ground whose axes are known, not by the exact clip.

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "judging.hpp"

namespace groundtruth::judge {
namespace {

constexpr double reach = 20;  // decision, number and 4 times the decision of slack, with room to spare

// A force on ground that leans about y by the angle of a 3-4-5 triangle, in the ground's axes.
struct Leaning {
  Vector in_ground;
  double friction;
  double brake;

  double pressing() const { return std::fabs(in_ground[2]); }
  double size() const { return std::hypot(in_ground[0], in_ground[1], in_ground[2]); }
};

Vector in_wheel(const Vector& f) { return {(4 * f[0] - 3 * f[2]) / 5, f[1], (3 * f[0] + 4 * f[2]) / 5}; }

ClipAsk ask_of(const Leaning& load) {
  ClipAsk ask;
  ask.normal_in_wheel = {3, 0, -4};
  ask.force_in_wheel = in_wheel(load.in_ground);
  ask.friction = load.friction;
  ask.brake = load.brake;
  return ask;
}

// By how much of ||F|| the force leaves the border; negative inside.
double excess(const Leaning& load, const Vector& in_ground) {
  const double off_disc = std::hypot(in_ground[0], in_ground[1]) - load.friction * load.pressing();
  return std::max(off_disc, std::fabs(in_ground[0]) - load.brake) / load.size();
}

class RandomLoad {
 public:
  explicit RandomLoad(std::uint64_t seed) : random_(seed) {}

  Leaning next() {
    Leaning load{{of_any_size(), of_any_size(), -std::fabs(of_any_size())}, part_(random_) + 1, 0};
    load.brake = std::fabs(of_any_size());
    return load;
  }
  double part() { return part_(random_); }

 private:
  double of_any_size() { return std::ldexp(part(), static_cast<int>(3 * part())); }

  std::mt19937_64 random_;
  std::uniform_real_distribution<double> part_{-1, 1};
};

bool accepts(const Tolerance& tolerance, const Leaning& load, Grip grip, const Vector& in_ground) {
  const Answer got{ClipAnswer{Clipped{grip, in_wheel(in_ground)}}};
  return difference(iced_box(), tolerance, ask_of(load), got) == Difference::none;
}

RC_GTEST_PROP(RefutedForces, AreRejected, (std::uint64_t seed)) {
  RandomLoad random(seed);
  for (const char* profile : {"double", "float", "game"}) {
    const Tolerance& tolerance = tolerance_of(profile);
    const double allowed = reach * tolerance.relative_decision * 3;  // friction may be 2
    const Leaning load = random.next();
    const Vector& f = load.in_ground;
    const double out = excess(load, f);
    if (out > allowed) RC_ASSERT(!accepts(tolerance, load, Grip::stick, f));
    if (out < -allowed) RC_ASSERT(!accepts(tolerance, load, Grip::slip, f));
    const Vector other{f[0] * random.part(), f[1] * random.part(), f[2]};
    if (excess(load, other) > allowed || excess(load, other) < -allowed)
      RC_ASSERT(!accepts(tolerance, load, Grip::slip, other));
    const Vector pressed{other[0], other[1], f[2] - allowed * load.size()};
    RC_ASSERT(!accepts(tolerance, load, Grip::slip, pressed));
    RC_ASSERT(!accepts(tolerance, load, Grip::stick, pressed));
  }
}

}  // namespace
}  // namespace groundtruth::judge
