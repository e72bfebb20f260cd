#include <groundtruth/diagnosis/inputs.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace groundtruth::diagnosis {
namespace {

using Visit = std::function<void(const std::string&, double&)>;

class NumberWalk {
 public:
  explicit NumberWalk(const Visit& visit) : visit_(visit) {}

  void operator()(EntryAsk& ask) {
    each("from", ask.from);
    each("to", ask.to);
    visit_("range[0]", ask.lambda_first);
    visit_("range[1]", ask.lambda_last);
  }
  void operator()(ClipAsk& ask) {
    each("force", ask.force_in_wheel);
    each("normal", ask.normal_in_wheel);
    visit_("friction", ask.friction);
    visit_("brake", ask.brake);
    visit_("min_uprightness", ask.min_uprightness);
  }
  void operator()(StepAsk& ask) {
    Wheel& wheel = ask.wheel;
    visit_("wheel.k_xy", wheel.k_xy), visit_("wheel.k_z", wheel.k_z);
    visit_("wheel.d_xy", wheel.d_xy), visit_("wheel.d_z", wheel.d_z);
    visit_("wheel.z_min", wheel.z_min), visit_("wheel.z_zero", wheel.z_zero),
        visit_("wheel.z_max", wheel.z_max);
    visit_("wheel.min_uprightness", wheel.min_uprightness);
    each("frame.position", ask.frame.position_in_world);
    each("frame.orientation", ask.frame.world_from_wheel);
    each("frame.velocity", ask.frame.velocity_in_world);
    each("frame.angular_velocity", ask.frame.angular_velocity_in_world);
    visit_("brake", ask.brake), visit_("h", ask.h);
    if (auto* contact = std::get_if<Contact>(&ask.state)) (*this)(*contact);
  }

  void operator()(Shape& shape) {
    std::visit([this](auto& expression) { (*this)(expression); }, shape.expression);
  }
  void operator()(Everything&) {}
  void operator()(Nothing&) {}
  void operator()(HalfSpace& half_space) {
    const std::string name = regions_ > 0 ? "region" : "leaf " + std::to_string(leaf_++);
    each(name + " normal", half_space.normal);
    visit_(name + " offset", half_space.offset);
  }
  void operator()(Union& shape) {
    for (Shape& operand : shape.operands) (*this)(operand);
  }
  void operator()(Intersection& shape) {
    for (Shape& operand : shape.operands) (*this)(operand);
  }
  void operator()(Covered& cover) { within(cover.over); }
  void operator()(Painted& paint) {
    ++regions_;
    within(paint.where);
    --regions_;
    within(paint.over);
  }

 private:
  template <std::size_t n>
  void each(const std::string& name, std::array<double, n>& numbers) {
    for (std::size_t i = 0; i < n; ++i) visit_(name + "[" + std::to_string(i) + "]", numbers[i]);
  }
  void operator()(Contact& contact) {
    each("state.pebble", contact.pebble_in_world);
    each("state.velocity", contact.pebble_velocity_in_world);
    each("state.normal", contact.normal_in_world);
    visit_("state.static", contact.static_friction);
    visit_("state.dynamic", contact.dynamic_friction);
    if (contact.maximum_force) visit_("state.max_force", *contact.maximum_force);
  }
  // Shapes share what they stand over; a change must not reach other cases.
  void within(std::shared_ptr<const Shape>& shared) {
    Shape own = *shared;
    (*this)(own);
    shared = std::make_shared<Shape>(std::move(own));
  }

  const Visit& visit_;
  std::size_t leaf_ = 0;
  int regions_ = 0;
};

bool is_well_formed(const EntryAsk& ask) { return ask.lambda_first <= ask.lambda_last; }
bool is_well_formed(const ClipAsk& ask) {
  return ask.friction >= 0 && ask.brake >= 0 && ask.min_uprightness > 0;
}
bool is_well_formed(const StepAsk& ask) {
  const Wheel& wheel = ask.wheel;
  const auto& q = ask.frame.world_from_wheel;
  const bool has_wheel = wheel.k_xy < 0 && wheel.k_z < 0 && wheel.d_xy <= 0 && wheel.d_z <= 0 &&
                         wheel.z_min < wheel.z_zero && wheel.z_zero <= wheel.z_max &&
                         wheel.min_uprightness > 0;
  const bool is_turned = std::any_of(q.begin(), q.end(), [](double x) { return x != 0; });
  const auto* contact = std::get_if<Contact>(&ask.state);
  const bool has_contact =
      contact == nullptr || (contact->static_friction >= 0 && contact->dynamic_friction >= 0 &&
                             contact->maximum_force.value_or(0) >= 0);
  return has_wheel && is_turned && has_contact && ask.brake >= 0 && ask.h > 0;
}

}  // namespace

void for_each_number(cases::Case& with, const Visit& visit) {
  NumberWalk walk(visit);
  std::visit(walk, with.ask);
  walk(with.scene.shape);
}

std::vector<std::string> names_of_numbers(const cases::Case& with) {
  cases::Case copy = with;
  std::vector<std::string> names;
  for_each_number(copy, [&](const std::string& name, double&) { names.push_back(name); });
  return names;
}

bool is_well_formed(const cases::Case& with) {
  cases::Case copy = with;
  bool is_finite = true;
  for_each_number(
      copy, [&](const std::string&, double& number) { is_finite = is_finite && std::isfinite(number); });
  return is_finite && std::visit([](const auto& ask) { return is_well_formed(ask); }, with.ask);
}

}  // namespace groundtruth::diagnosis
