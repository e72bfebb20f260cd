#include <groundtruth/explanation/explanation.hpp>

#include "clip_numbers.hpp"
#include "wording.hpp"

namespace groundtruth::explanation {
namespace {

// v -> q v q^-1, by its matrix.
class Rotation {
 public:
  explicit Rotation(const Quaternion& q) {
    const Rational w(q[0]), x(q[1]), y(q[2]), z(q[3]);
    const Rational s = w * w + x * x + y * y + z * z;
    rows_ = {{{(w * w + x * x - y * y - z * z) / s, 2 * (x * y - w * z) / s, 2 * (x * z + w * y) / s},
              {2 * (x * y + w * z) / s, (w * w - x * x + y * y - z * z) / s, 2 * (y * z - w * x) / s},
              {2 * (x * z - w * y) / s, 2 * (y * z + w * x) / s, (w * w - x * x - y * y + z * z) / s}}};
  }
  RationalVector operator()(const RationalVector& v) const {
    return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)};
  }
  RationalVector inverse(const RationalVector& v) const {
    return along(along(along({}, v[0], rows_[0]), v[1], rows_[1]), v[2], rows_[2]);
  }

 private:
  std::array<RationalVector, 3> rows_;
};

class Path {
 public:
  Path(const Scene& scene, const StepAsk& ask, const StepAnswer& answer)
      : scene_(scene), ask_(ask), rotation_(ask.frame.world_from_wheel) {
    facts_.to = end_in_words(answer);
    const auto* stepped = std::get_if<Stepped>(&answer);
    if (stepped == nullptr) return;
    facts_.force_after = rotation_.inverse(minus({}, rational(stepped->force_on_frame_in_world)));
    const auto* contact = std::get_if<Contact>(&stepped->state);
    if (contact == nullptr) return;
    const RationalVector origin = rational(ask.frame.position_in_world);
    facts_.pebble_after = rotation_.inverse(minus(rational(contact->pebble_in_world), origin));
    facts_.normal = rotation_.inverse(rational(contact->normal_in_world));
  }

  StepFacts take() && {
    std::visit([this](const auto& state) { from(state); }, ask_.state);
    return std::move(facts_);
  }

 private:
  // Asks whether left >= right (or left > right); true if that ends the step.
  bool ends(const std::string& asks, const Rational& left, const Rational& right, bool holds,
            const std::string& leads_to) {
    facts_.questions.push_back({asks, write_approximately(left), write_approximately(right), holds,
                                holds ? leads_to : "", write_approximately(abs(Rational(left - right)))});
    return holds;
  }

  void from(const Free&) {
    facts_.from = "free";
    const RationalVector origin = rational(ask_.frame.position_in_world);
    const RationalVector down = rotation_({0, 0, 1});
    const Rational top(ask_.wheel.z_min), bottom(ask_.wheel.z_max);
    const Segment strut{along(origin, top, down), along({}, Rational(bottom - top), down), 0, 1};
    facts_.landing = facts_of(scene_, strut);
    const std::optional<Rational>& lambda = facts_.landing->decision.lambda;
    const bool touches = lambda && *lambda < 1;
    facts_.questions.push_back({"the strut from z_min to z_max meets the ground before its end",
                                lambda ? "lambda " + write_fraction(*lambda) : "miss", "1", touches,
                                touches ? "" : "free",
                                lambda ? write_approximately(abs(Rational(1 - *lambda))) : ""});
    if (!touches) return;
    if (ends("lambda = 0: the ground is at z_min", *lambda, 0, *lambda == 0, "wheel broken")) return;
    const std::optional<std::size_t> face = facts_.landing->decision.canonical;
    if (!face) return;
    const RationalVector normal = rotation_.inverse(facts_.landing->in_play.planes[*face].normal);
    if (is_steep(normal)) return;
    facts_.questions.push_back({"the ground has friction for this tyre", "", "", true, facts_.to, ""});
  }

  bool is_steep(const RationalVector& n) {
    const Rational level = n[0] * n[0] + n[1] * n[1];
    const bool steep = !is_upright(n, Rational(ask_.wheel.min_uprightness));
    facts_.questions.push_back(
        {"the surface is too steep: -n_z below min_uprightness times its level part",
         write_approximately(-n[2]),
         write_root(Rational(ask_.wheel.min_uprightness) * Rational(ask_.wheel.min_uprightness) * level),
         steep, steep ? "surface too steep" : "", ""});
    return steep;
  }

  void from(const Contact& contact) {
    facts_.from = contact.grip == Grip::stick ? "stick" : "slip";
    const Frame& frame = ask_.frame;
    const Wheel& wheel = ask_.wheel;
    const RationalVector arm = minus(rational(contact.pebble_in_world), rational(frame.position_in_world));
    const RationalVector p = rotation_.inverse(arm);
    const RationalVector turning = cross(rational(frame.angular_velocity_in_world), arm);
    const RationalVector w = rotation_.inverse(
        minus(minus(rational(contact.pebble_velocity_in_world), rational(frame.velocity_in_world)), turning));
    const RationalVector n = rotation_.inverse(rational(contact.normal_in_world));
    facts_.pebble_before = p;
    facts_.normal = n;
    facts_.springs_force = {
        Rational(wheel.k_xy) * p[0] + Rational(wheel.d_xy) * w[0],
        Rational(wheel.k_xy) * p[1] + Rational(wheel.d_xy) * w[1],
        Rational(wheel.k_z) * (p[2] - Rational(wheel.z_zero)) + Rational(wheel.d_z) * w[2]};
    const Rational z_max(wheel.z_max), z_min(wheel.z_min);
    if (ends("the pebble is at or beyond the strut's end: p_z >= z_max", p[2], z_max, p[2] >= z_max, "free"))
      return;
    if (ends("the strut is used up: p_z <= z_min", p[2], z_min, p[2] <= z_min, "wheel broken")) return;
    if (is_steep(n)) return;
    if (!is_pressed(contact, n)) return;
    clip(contact, n);
  }

  // Whether a force that the ground bears presses pebble and ground together.
  bool is_pressed(const Contact& contact, const RationalVector& n) {
    const Rational pressing = -dot(facts_.springs_force, n);  // ||n|| F'_z
    const Rational squared = pressing * pressing / dot(n, n);
    const std::string signed_root = (pressing < 0 ? "-" : "") + write_root(squared);
    facts_.questions.push_back({"nothing presses them together: F'_z <= 0", signed_root, "0", pressing <= 0,
                                pressing <= 0 ? "free" : "", write_root(squared)});
    if (pressing <= 0) return false;
    if (!contact.maximum_force) return true;
    const Rational most(*contact.maximum_force);
    const bool gives_way = squared > most * most;
    facts_.questions.push_back({"the ground gives way: F'_z > max_force", signed_root,
                                write_approximately(most), gives_way, gives_way ? "surface gave way" : "",
                                ""});
    return !gives_way;
  }

  void clip(const Contact& contact, const RationalVector& n) {
    const double friction = contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
    facts_.clip = clip_facts({facts_.springs_force, n, Rational(friction), Rational(ask_.brake),
                              Rational(ask_.wheel.min_uprightness)});
    const bool slips = facts_.clip->which != ClipCase::stick;
    facts_.questions.push_back(
        {"the force leaves the pebble's border", "|F'_xy| " + write_root(facts_.clip->tangential_squared()),
         "mu N " + write_root(facts_.clip->disc_squared()), slips, slips ? "" : "stick", ""});
    if (slips)
      facts_.questions.push_back({"the pebble moves; the strut from there meets the ground before its end",
                                  "", "", facts_.to == "slip", facts_.to, ""});
  }

  const Scene& scene_;
  const StepAsk& ask_;
  Rotation rotation_;
  StepFacts facts_;
};

}  // namespace

StepFacts facts_of(const Scene& scene, const StepAsk& ask, const StepAnswer& answer) {
  return Path(scene, ask, answer).take();
}

}  // namespace groundtruth::explanation
