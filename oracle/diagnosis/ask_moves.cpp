#include <algorithm>
#include <cmath>
#include <vector>

#include <groundtruth/diagnosis/inputs.hpp>
#include <groundtruth/diagnosis/moves.hpp>

namespace groundtruth::diagnosis {
namespace {

template <class AskKind, class Change>
void add(std::vector<cases::Case>& result, const cases::Case& from, Change change) {
  result.push_back(from);
  change(std::get<AskKind>(result.back().ask));
}

void move_solid(Scene& scene, const Vector& by) {
  cases::Case moved{{}, scene, EntryAsk{}, {}, {}};
  Vector normal{};
  for_each_number(moved, [&](const std::string& name, double& number) {
    if (name.ends_with("offset")) number += normal[0] * by[0] + normal[1] * by[1] + normal[2] * by[2];
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (name.ends_with("normal[" + std::to_string(axis) + "]")) normal[axis] = number;
  });
  scene = std::move(moved.scene);
}

Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector opposite(const Vector& v) { return {0 - v[0], 0 - v[1], 0 - v[2]}; }

void add_entry_moves(std::vector<cases::Case>& result, const cases::Case& from, const EntryAsk& ask) {
  add<EntryAsk>(result, from, [](EntryAsk& a) { a.lambda_first = 0, a.lambda_last = 1; });
  add<EntryAsk>(result, from, [](EntryAsk& a) { a.lambda_first = 0; });
  add<EntryAsk>(result, from, [](EntryAsk& a) { a.lambda_last = 1; });
  for (const Vector& origin : {ask.from, ask.to}) {
    add<EntryAsk>(result, from, [&](EntryAsk& a) {
      a.from = sum(a.from, opposite(origin));
      a.to = sum(a.to, opposite(origin));
    });
    move_solid(result.back().scene, opposite(origin));
  }
  // The part of the segment that is asked about, as a segment of its own.
  add<EntryAsk>(result, from, [](EntryAsk& a) {
    const EntryAsk whole = a;
    for (std::size_t i = 0; i < 3; ++i) {
      a.from[i] = whole.from[i] + whole.lambda_first * (whole.to[i] - whole.from[i]);
      a.to[i] = whole.from[i] + whole.lambda_last * (whole.to[i] - whole.from[i]);
    }
    a.lambda_first = 0, a.lambda_last = 1;
  });
}

// Together where a limit binds them: friction with brake, and all forces by one scale.
void add_clip_moves(std::vector<cases::Case>& result, const cases::Case& from, const ClipAsk& ask) {
  add<ClipAsk>(result, from, [](ClipAsk& a) { a.min_uprightness = default_min_uprightness; });
  add<ClipAsk>(result, from, [](ClipAsk& a) { a.normal_in_wheel = {0, 0, -1}; });
  if (ask.friction > 0) add<ClipAsk>(result, from, [](ClipAsk& a) { a.brake /= a.friction, a.friction = 1; });
  for (const double force : ask.force_in_wheel) {
    if (force == 0) continue;
    add<ClipAsk>(result, from, [scale = std::abs(force)](ClipAsk& a) {
      for (double& x : a.force_in_wheel) x /= scale;
      a.brake /= scale;
    });
  }
}

void add_step_moves(std::vector<cases::Case>& result, const cases::Case& from, const StepAsk& ask) {
  add<StepAsk>(result, from, [](StepAsk& a) { a.state = Free{}; });
  add<StepAsk>(result, from, [](StepAsk& a) { a.frame.world_from_wheel = {1, 0, 0, 0}; });
  add<StepAsk>(result, from, [](StepAsk& a) { a.frame.world_from_wheel = {0, 1, 0, 0}; });
  add<StepAsk>(result, from, [](StepAsk& a) { a.frame.velocity_in_world = {}; });
  add<StepAsk>(result, from, [](StepAsk& a) { a.frame.angular_velocity_in_world = {}; });
  add<StepAsk>(result, from, [](StepAsk& a) { a.wheel.relocation = Relocation::spring; });
  add<StepAsk>(result, from, [](StepAsk& a) { a.wheel.d_xy = a.wheel.d_z = 0; });
  add<StepAsk>(result, from, [](StepAsk& a) {
    a.wheel.k_xy = a.wheel.k_z = -1, a.wheel.d_xy = a.wheel.d_z = 0;
    a.wheel.z_min = 0, a.wheel.z_zero = a.wheel.z_max = 1;
  });
  const Vector by = opposite(ask.frame.position_in_world);
  add<StepAsk>(result, from, [&](StepAsk& a) {
    a.frame.position_in_world = {};
    if (auto* contact = std::get_if<Contact>(&a.state))
      contact->pebble_in_world = sum(contact->pebble_in_world, by);
  });
  move_solid(result.back().scene, by);
  if (!std::holds_alternative<Contact>(ask.state)) return;
  const auto add_contact_move = [&](auto change) {
    add<StepAsk>(result, from, [&](StepAsk& a) { change(std::get<Contact>(a.state)); });
  };
  add_contact_move([](Contact& contact) { contact.maximum_force.reset(); });
  add_contact_move([](Contact& contact) { contact.pebble_velocity_in_world = {}; });
  add_contact_move([](Contact& contact) { contact.normal_in_world = {0, 0, 1}; });
  add_contact_move([](Contact& contact) { contact.grip = Grip::stick; });
  add_contact_move([](Contact& contact) { contact.dynamic_friction = contact.static_friction; });
}

}  // namespace

bool with_ordinary_ask(const cases::Case& from, const Take& take) {
  std::vector<cases::Case> result;
  if (const auto* entry = std::get_if<EntryAsk>(&from.ask)) add_entry_moves(result, from, *entry);
  if (const auto* step = std::get_if<StepAsk>(&from.ask)) add_step_moves(result, from, *step);
  if (const auto* clip = std::get_if<ClipAsk>(&from.ask)) add_clip_moves(result, from, *clip);
  if (!std::holds_alternative<EntryAsk>(from.ask)) {
    result.push_back(from);
    result.back().scene = {{}, {Nothing{}}};
  }
  return std::all_of(result.begin(), result.end(),
                     [&](cases::Case& candidate) { return take(std::move(candidate)); });
}

}  // namespace groundtruth::diagnosis
