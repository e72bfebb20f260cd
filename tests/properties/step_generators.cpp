#include <algorithm>
#include <cmath>

#include <groundtruth/tests/properties/motions.hpp>
#include <groundtruth/tests/properties/shrinking.hpp>

namespace groundtruth::properties {
namespace {

// In a world whose z points down, like an upright wheel's: what it may stand on.
Shape some_ground(Dice& dice) {
  const double depth = dice.whole(0, 5);
  switch (dice.whole(0, 8)) {
    case 0:  // a ramp
      return half_space(dice.whole(-2, 2), dice.whole(-2, 2), -dice.whole(1, 4), -depth);
    case 1: {  // a kerb
      const Vector low{static_cast<double>(dice.whole(-2, 1)), static_cast<double>(dice.whole(-2, 1)), depth};
      return box(low, {low[0] + dice.whole(0, 2), low[1] + dice.whole(0, 2), low[2] + dice.whole(0, 2)});
    }
    case 2:  // a wall
      return half_space(dice.pick({-1, 1}), 0, 0, dice.whole(-2, 1));
    default:
      return half_space(0, 0, -1, -depth);
  }
}

Shape some_scene(Dice& dice) {
  if (dice.one_in(12)) return lattice_shape(dice, 2);
  std::vector<Shape> parts;
  for (int count = dice.whole(1, 3); count > 0; --count) {
    const auto material = static_cast<MaterialIndex>(dice.pick({0, 0, 0, 0, 1, 2, 3}));
    Shape part = dice.one_in(10) ? some_ground(dice) : covered(material, some_ground(dice));
    if (dice.one_in(6)) part = painted(3, some_ground(dice), part);
    parts.push_back(std::move(part));
  }
  return any_of(std::move(parts));
}

Wheel some_wheel(Dice& dice) {
  Wheel wheel;
  wheel.k_xy = -dice.pick({1, 2, 3, 4});
  wheel.k_z = -dice.pick({1, 2, 4, 8});
  wheel.d_xy = -dice.pick({0, 1, 2});
  wheel.d_z = -dice.pick({0, 1});
  wheel.z_min = dice.whole(-1, 1);
  wheel.z_zero = wheel.z_min + dice.whole(1, 3);
  wheel.z_max = wheel.z_zero + dice.pick({0, 0, 1});
  wheel.tyre = dice.one_in(16) ? "wood" : "rubber";
  if (dice.one_in(4)) wheel.min_uprightness = dice.pick({0.5, 1.0, 2.0});
  wheel.relocation = dice.one_in(2) ? Relocation::spring : Relocation::return_mapping;
  return wheel;
}

Contact some_contact(const StepAsk& ask, Dice& dice) {
  const Wheel& wheel = ask.wheel;
  Contact contact;
  contact.grip = dice.one_in(2) ? Grip::stick : Grip::slip;
  contact.pebble_in_world = lattice_vector(dice, 2);
  const int travel = static_cast<int>(2 * (wheel.z_max - wheel.z_min));
  const int end = dice.one_in(4) ? 0 : 1;  // 0: on the very ends as well
  contact.pebble_in_world[2] = wheel.z_min + dice.whole(end, travel - end) / 2.0;
  for (std::size_t i = 0; i < 3; ++i) contact.pebble_in_world[i] += ask.frame.position_in_world[i];
  contact.pebble_velocity_in_world = lattice_vector(dice, dice.whole(0, 2));
  contact.normal_in_world = {0, 0, -1};
  if (dice.one_in(2)) contact.normal_in_world = lattice_vector(dice, 2);
  if (!dice.one_in(8)) contact.normal_in_world[2] = -dice.whole(1, 4);
  contact.static_friction = dice.whole(0, 6) / 4.0;
  contact.dynamic_friction = dice.whole(0, 4) / 4.0;
  if (dice.one_in(3)) contact.maximum_force = dice.whole(0, 16);
  return contact;
}

// As if the world's z pointed down.
StepCase level_step(Dice& dice) {
  StepCase c;
  StepAsk& ask = c.ask;
  ask.wheel = some_wheel(dice);
  ask.brake = dice.pick({0.0, 1.0, 2.0, 3.0, 0.5, 1e3});
  ask.h = dice.pick({1.0, 0.5, 0.25, 3.0});
  ask.frame.position_in_world = lattice_vector(dice, 1);
  ask.frame.velocity_in_world = lattice_vector(dice, dice.whole(0, 2));
  if (dice.one_in(2)) ask.frame.angular_velocity_in_world = lattice_vector(dice, 1);
  if (dice.one_in(3)) {
    ask.frame.world_from_wheel = dice.pick<Quaternion>(
        {{2, 1, 0, 0}, {3, 0, -1, 0}, {5, 1, 1, 0}, {1, 0, 0, 3}, {-7, 1, 2, 3}, {4, 0, 0, 0}});
  }
  if (!dice.one_in(6)) ask.state = some_contact(ask, dice);
  c.shape = some_scene(dice);
  const double within_reach = ask.frame.position_in_world[2] + ask.wheel.z_min + 1;
  if (!dice.one_in(3))
    c.shape = covered(dice.pick<MaterialIndex>({0, 0, 3}), half_space(0, 0, -1, -within_reach));
  return c;
}

StepCase lattice_step(Dice& dice) {
  return moved(level_step(dice), quarter_turns(dice), lattice_vector(dice, dice.whole(0, 1)));
}

// Rarely, as exact numbers of thousands of digits take the second witness long.
constexpr int odd_one_in = 400;

StepCase wild_step(Dice& dice) {
  StepCase c = lattice_step(dice);
  const auto wobble = [&dice](double& number) { number = wobbled(number, dice, odd_one_in); };
  const auto wobble_all = [&](Vector& vector) { std::for_each(vector.begin(), vector.end(), wobble); };
  c.shape = mapped(c.shape, [&](HalfSpace h) {
    wobble_all(h.normal);
    wobble(h.offset);
    return h;
  });
  Frame& frame = c.ask.frame;
  wobble_all(frame.position_in_world);
  wobble_all(frame.velocity_in_world);
  wobble_all(frame.angular_velocity_in_world);
  const Quaternion before = frame.world_from_wheel;
  std::for_each(frame.world_from_wheel.begin(), frame.world_from_wheel.end(), wobble);
  if (frame.world_from_wheel == Quaternion{}) frame.world_from_wheel = before;
  if (auto* contact = std::get_if<Contact>(&c.ask.state)) {
    wobble_all(contact->pebble_in_world);
    wobble_all(contact->pebble_velocity_in_world);
    wobble_all(contact->normal_in_world);
  }
  c.ask.brake = std::fabs(wobbled(c.ask.brake, dice, odd_one_in));
  return c;
}

}  // namespace

rc::Gen<StepCase> lattice_steps() { return shrinking(lattice_step); }
rc::Gen<StepCase> wild_steps() { return shrinking(wild_step); }

}  // namespace groundtruth::properties
