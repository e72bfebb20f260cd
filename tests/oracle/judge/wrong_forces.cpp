// Wrong answers about forces and wheels.

#include <algorithm>
#include <cmath>

#include "wrong_kinds.hpp"

namespace groundtruth::judge {
namespace {

constexpr double change = 1e-9;  // of the largest term

Grip other(Grip grip) { return grip == Grip::stick ? Grip::slip : Grip::stick; }

double apart(const Vector& a, const Vector& b) { return size_of({a[0] - b[0], a[1] - b[1], a[2] - b[2]}); }

// As if the frame were turned by a quarter about the axis (1, 1, 1).
Vector in_another_frame(const Vector& v) { return {v[1], v[2], v[0]}; }

// Of a step's force, pebble and velocity, by local terms only.
struct Terms {
  double force = 0;
  double pebble = 0;
  double velocity = 0;
};

Terms terms_of(const StepAsk& ask) {
  Terms terms;
  terms.pebble = 1 + std::fabs(ask.wheel.z_min) + std::fabs(ask.wheel.z_max);
  const auto* contact = std::get_if<Contact>(&ask.state);
  if (contact == nullptr) return terms;
  const double arm = apart(contact->pebble_in_world, ask.frame.position_in_world);
  const double speed = size_of(contact->pebble_velocity_in_world) + size_of(ask.frame.velocity_in_world) +
                       size_of(ask.frame.angular_velocity_in_world) * arm;
  const double k = std::max(std::fabs(ask.wheel.k_xy), std::fabs(ask.wheel.k_z));
  const double d = std::max(std::fabs(ask.wheel.d_xy), std::fabs(ask.wheel.d_z));
  const double friction = std::max({1.0, contact->static_friction, contact->dynamic_friction});
  terms.force = friction * (k * (arm + std::fabs(ask.wheel.z_zero)) + d * speed);
  const double softest = std::fabs(ask.wheel.k_xy);
  terms.pebble += arm + (terms.force + std::fabs(ask.wheel.d_xy) / ask.h * arm) / softest;
  terms.velocity = speed + terms.pebble / ask.h;
  return terms;
}

class WrongContacts {
 public:
  WrongContacts(const StepAsk& ask, const Stepped& exact) : terms_(terms_of(ask)), exact_(exact) {}

  std::vector<WrongAnswer> all() && {
    const Contact& contact = std::get<Contact>(exact_.state);
    add("free for contact", [](Stepped& s) { s.state = Free{}; });
    edit("grip flipped", [](Contact& c) { c.grip = other(c.grip); });
    edit("normal negated", [](Contact& c) {
      for (double& component : c.normal_in_world) component = -component;
    });
    const double size = size_of(contact.normal_in_world);
    const std::vector<Vector> turned = nearby(contact.normal_in_world, 6e-8 * size);
    for (std::size_t i = 0; i < 3; ++i) {
      const bool aside = std::fabs(contact.normal_in_world[i]) < 0.9 * size;
      edit(
          "normal turned by a float's rounding", [&](Contact& c) { c.normal_in_world = turned[i]; }, aside);
    }
    edit("static friction", [](Contact& c) { c.static_friction += 1e-9 + c.static_friction * 1e-9; });
    edit("dynamic friction", [](Contact& c) { c.dynamic_friction += 1e-9 + c.dynamic_friction * 1e-9; });
    edit(
        "frictions swapped", [](Contact& c) { std::swap(c.static_friction, c.dynamic_friction); },
        std::fabs(contact.static_friction - contact.dynamic_friction) > 1e-9);
    edit("another limit",
         [](Contact& c) { c.maximum_force = c.maximum_force ? *c.maximum_force * 2 + 1 : 0; });
    edit(
        "no limit", [](Contact& c) { c.maximum_force.reset(); }, contact.maximum_force.has_value());
    const double slant = 1e3;  // a strut that meets the ground aslant lands that much less surely
    for (const Vector& pebble : nearby(contact.pebble_in_world, change * slant * terms_.pebble))
      edit("pebble moved", [&](Contact& c) { c.pebble_in_world = pebble; });
    const double speed = change * slant * terms_.velocity + (contact.grip == Grip::stick ? change : 0);
    for (const Vector& velocity : nearby(contact.pebble_velocity_in_world, speed))
      edit("pebble velocity", [&](Contact& c) { c.pebble_velocity_in_world = velocity; });
    return std::move(wrong_);
  }

 private:
  template <typename Edit>
  void add(const char* what, const Edit& edit) {
    Stepped stepped = exact_;
    edit(stepped);
    wrong_.push_back({what, StepAnswer{stepped}});
  }
  template <typename Edit>
  void edit(const char* what, const Edit& edit, bool differs = true) {
    if (differs) add(what, [&](Stepped& s) { edit(std::get<Contact>(s.state)); });
  }

  Terms terms_;
  const Stepped& exact_;
  std::vector<WrongAnswer> wrong_;
};

}  // namespace

std::vector<WrongAnswer> wrong_clips(const ClipAsk& ask, const ClipAnswer& exact) {
  std::vector<WrongAnswer> wrong;
  const auto add = [&](const char* what, const ClipAnswer& answer) { wrong.push_back({what, answer}); };
  if (!std::holds_alternative<TooSteep>(exact)) add("too steep", TooSteep{});
  if (!std::holds_alternative<Refusal>(exact)) add("a refusal that is not due", Refusal{"no"});
  const auto* clipped = std::get_if<Clipped>(&exact);
  if (clipped == nullptr) {
    add("a force where none is due", Clipped{Grip::stick, ask.force_in_wheel});
    add("a force where none is due", Clipped{Grip::slip, {}});
    return wrong;
  }
  const auto with = [&](const char* what, const Vector& force) { add(what, Clipped{clipped->grip, force}); };
  add("grip flipped", Clipped{other(clipped->grip), clipped->force_in_wheel});
  const double least = change * size_of(ask.force_in_wheel) * std::max(1.0, ask.friction) + 1e-300;
  for (const Vector& force : nearby(clipped->force_in_wheel, least)) with("force component", force);
  for (const Vector& force : flipped(clipped->force_in_wheel, least)) with("force component flipped", force);
  const Vector turned = in_another_frame(clipped->force_in_wheel);
  if (apart(turned, clipped->force_in_wheel) > 2 * least) with("force in another frame", turned);
  return wrong;
}

std::vector<WrongAnswer> wrong_steps(const StepAsk& ask, const StepAnswer& exact) {
  std::vector<WrongAnswer> wrong;
  const auto add = [&](const char* what, const StepAnswer& answer) { wrong.push_back({what, answer}); };
  for (const StepFailure failure :
       {StepFailure::wheel_broken, StepFailure::surface_too_steep, StepFailure::surface_gave_way}) {
    if (exact != StepAnswer{failure}) add("another outcome", failure);
  }
  if (!std::holds_alternative<Refusal>(exact)) add("a refusal that is not due", Refusal{"no"});
  const auto* stepped = std::get_if<Stepped>(&exact);
  const Contact invented{Grip::stick, ask.frame.position_in_world, {}, {0.25, 0.5, 7}, 0.1, 0.1, {}};
  if (stepped == nullptr || std::holds_alternative<Free>(stepped->state))
    add("a contact where none is due", Stepped{invented, {}});
  if (stepped == nullptr) {
    add("free where a failure or refusal is due", Stepped{Free{}, {}});
    return wrong;
  }
  if (std::holds_alternative<Contact>(stepped->state)) wrong = WrongContacts(ask, *stepped).all();
  const double least = change * terms_of(ask).force + 1e-300;
  const auto with = [&](const char* what, const Vector& force) { add(what, Stepped{stepped->state, force}); };
  for (const Vector& force : nearby(stepped->force_on_frame_in_world, least)) with("force component", force);
  for (const Vector& force : flipped(stepped->force_on_frame_in_world, least))
    with("force component flipped", force);
  const Vector turned = in_another_frame(stepped->force_on_frame_in_world);
  if (apart(turned, stepped->force_on_frame_in_world) > 2 * least) with("force in another frame", turned);
  return wrong;
}

}  // namespace groundtruth::judge
