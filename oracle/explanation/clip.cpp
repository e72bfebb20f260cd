#include "clip_numbers.hpp"

namespace groundtruth::explanation {
namespace {

ClipCase case_of(const ClipFacts& f) {
  const Rational brake_squared = f.brake * f.brake;
  const Rational disc_squared = f.disc_squared();
  if (f.x_squared <= brake_squared && f.tangential_squared() <= disc_squared) return ClipCase::stick;
  if (brake_squared >= disc_squared) return ClipCase::circle;
  const Rational s_squared = disc_squared - brake_squared;
  if (f.y_squared <= s_squared) return ClipCase::band;
  return brake_squared * f.y_squared <= f.x_squared * s_squared ? ClipCase::corner : ClipCase::circle;
}

}  // namespace

bool is_upright(const RationalVector& n, const Rational& least) {
  return n[2] < 0 && n[2] * n[2] >= least * least * (n[0] * n[0] + n[1] * n[1]);
}

ClipFacts clip_facts(const ClipNumbers& numbers) {
  const RationalVector& n = numbers.normal_in_wheel;
  const RationalVector& force = numbers.force_in_wheel;
  ClipFacts facts;
  facts.friction = numbers.friction;
  facts.brake = numbers.brake;
  const Rational level = n[0] * n[0] + n[1] * n[1];
  if (level != 0) facts.uprightness_squared = n[2] * n[2] / level;
  facts.uprightness_needed_squared = numbers.min_uprightness * numbers.min_uprightness;
  if (!is_upright(n, numbers.min_uprightness)) {
    facts.which = ClipCase::too_steep;
    return facts;
  }
  const Rational r_squared = n[0] * n[0] + n[2] * n[2];
  const Rational n_squared = r_squared + n[1] * n[1];
  const Rational x_times_r = n[0] * force[2] - n[2] * force[0];
  const Rational y_times_rn = -n[0] * n[1] * force[0] + r_squared * force[1] - n[1] * n[2] * force[2];
  const Rational along_normal = dot(force, n);
  facts.x_squared = x_times_r * x_times_r / r_squared;
  facts.y_squared = y_times_rn * y_times_rn / (r_squared * n_squared);
  facts.normal_squared = along_normal * along_normal / n_squared;
  facts.x_sign = x_times_r.sign();
  facts.y_sign = y_times_rn.sign();
  facts.which = case_of(facts);
  return facts;
}

ClipFacts facts_of(const ClipAsk& ask) {
  return clip_facts({rational(ask.force_in_wheel), rational(ask.normal_in_wheel), Rational(ask.friction),
                     Rational(ask.brake), Rational(ask.min_uprightness)});
}

std::string_view name_of(ClipCase which) {
  switch (which) {
    case ClipCase::too_steep:
      return "too steep";
    case ClipCase::stick:
      return "stick";
    case ClipCase::band:
      return "case 1: the edge of the brake's band";
    case ClipCase::corner:
      return "case 2: the corner of band and disc";
    case ClipCase::circle:
      return "case 3: the friction disc's edge";
  }
  return "";
}

}  // namespace groundtruth::explanation
