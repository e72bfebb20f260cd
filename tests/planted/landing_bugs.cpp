// Mistakes of the step about where a strut meets the ground, and what a slip becomes.

#include "plain_step.hpp"

namespace groundtruth::planted {
namespace {

struct EndTouches : PlainStep {
  using PlainStep::PlainStep;
  bool is_end(double) const override { return false; }
};

struct EndTouchesInSlip : PlainStep {
  using PlainStep::PlainStep;
  bool is_end(double lambda) const override { return std::holds_alternative<Free>(ask.state) && lambda == 1; }
};

struct StandsAtStart : PlainStep {
  using PlainStep::PlainStep;
  bool is_start(const EntryAnswer& entry) const override { return std::holds_alternative<Inside>(entry); }
};

struct SteepLanding : PlainStep {
  using PlainStep::PlainStep;
  bool is_landing_upright(const Numbers& normal) const override {
    return std::holds_alternative<Contact>(ask.state) || PlainStep::is_landing_upright(normal);
  }
};

struct DefaultSteepLanding : PlainStep {
  using PlainStep::PlainStep;
  bool is_landing_upright(const Numbers& normal) const override {
    return PlainClip().is_upright(normal, default_min_uprightness);
  }
};

struct SteepInWorld : PlainStep {
  using PlainStep::PlainStep;
  bool is_landing_upright(const Numbers& normal_in_wheel) const override {
    const Numbers n = world_from_wheel(normal_in_wheel);
    return PlainStep::is_landing_upright({n[0], n[1], -abs(n[2])});
  }
};

struct RubberForAll : PlainStep {
  using PlainStep::PlainStep;
  Touch contact_on(const Border& border) const override {
    StepAsk on_rubber = ask;
    on_rubber.wheel.tyre = "rubber";
    const Touch touched = PlainStep::contact_on(border);
    if (!std::holds_alternative<Refusal>(touched)) return touched;
    return RubberForAll(on_rubber, right).PlainStep::contact_on(border);
  }
};

struct NoFrictionForStrangers : PlainStep {
  using PlainStep::PlainStep;
  Touch contact_on(const Border& border) const override {
    const Touch touched = PlainStep::contact_on(border);
    if (!std::holds_alternative<Refusal>(touched)) return touched;
    Contact contact;
    contact.normal_in_world = border.normal_in_world;
    return contact;
  }
};

struct NormalInWheel : PlainStep {
  using PlainStep::PlainStep;
  Touch contact_on(const Border& border) const override {
    Touch touched = PlainStep::contact_on(border);
    if (auto* contact = std::get_if<Contact>(&touched)) {
      contact->normal_in_world = doubles(world_from_wheel.inverse(numbers(contact->normal_in_world)));
    }
    return touched;
  }
};

struct WorldStrut : PlainStep {
  using PlainStep::PlainStep;
  EntryAsk strut(const Level& level) const override {
    EntryAsk asked = PlainStep::strut(level);
    asked.to = asked.from;
    const double down = world_from_wheel({0, 0, 1})[2] < 0 ? -1 : 1;
    asked.to[2] += down * (wheel.z_max - wheel.z_min);
    return asked;
  }
};

struct StrutToZero : PlainStep {
  using PlainStep::PlainStep;
  EntryAsk strut(const Level& level) const override {
    EntryAsk asked = PlainStep::strut(level);
    asked.to = doubles(to_world({level.x, level.y, wheel.z_zero}));
    return asked;
  }
};

struct SlipsAtFirst : PlainStep {
  using PlainStep::PlainStep;
  StepAnswer first_contact(Contact contact) const override {
    contact.grip = Grip::slip;
    return Stepped{contact, Vector{}};
  }
};

struct MovesAtFirst : PlainStep {
  using PlainStep::PlainStep;
  StepAnswer first_contact(Contact contact) const override {
    contact.grip = Grip::stick;
    contact.pebble_velocity_in_world = ask.frame.velocity_in_world;
    return Stepped{contact, Vector{}};
  }
};

// Where the pebble slips to.
template <Level (*place)(const StepAsk& ask, const Seen& seen, const Numbers& clipped)>
struct OtherPlace : PlainStep {
  using PlainStep::PlainStep;
  Level relocated(const Seen& in_wheel, const Numbers& clipped) const override {
    if (ask.wheel.relocation == Relocation::spring) return PlainStep::relocated(in_wheel, clipped);
    return place(ask, in_wheel, clipped);
  }
};

Level by_springs(const StepAsk& ask, const Seen&, const Numbers& clipped) {
  return {clipped[0] / ask.wheel.k_xy, clipped[1] / ask.wheel.k_xy};
}

Level mapped(const Wheel& wheel, const Number& rate, const Seen& seen, const Numbers& clipped) {
  const auto one = [&](std::size_t i) {
    return Number((clipped[i] + rate * seen.pebble[i] - wheel.d_xy * seen.velocity[i]) / (wheel.k_xy + rate));
  };
  return {one(0), one(1)};
}

Level without_h(const StepAsk& ask, const Seen& seen, const Numbers& clipped) {
  return mapped(ask.wheel, ask.wheel.d_xy, seen, clipped);
}

Level without_velocity(const StepAsk& ask, const Seen& seen, const Numbers& clipped) {
  return mapped(ask.wheel, Number(ask.wheel.d_xy) / ask.h, {seen.pebble, {}, seen.normal}, clipped);
}

struct ByVerticalSpring : PlainStep {
  using PlainStep::PlainStep;
  Level relocated(const Seen&, const Numbers& clipped) const override {
    return {clipped[0] / wheel.k_z, clipped[1] / wheel.k_z};
  }
};

struct SlipGoesOnInAir : PlainStep {
  using PlainStep::PlainStep;
  StepAnswer slide(const Contact& contact, const Touch& touched, const Vector& force) const override {
    if (!std::holds_alternative<Clear>(touched)) return PlainStep::slide(contact, touched, force);
    Contact kept = contact;
    kept.grip = Grip::slip;
    return Stepped{kept, force};
  }
};

struct ForceLostInAir : PlainStep {
  using PlainStep::PlainStep;
  StepAnswer slide(const Contact& contact, const Touch& touched, const Vector& force) const override {
    if (std::holds_alternative<Clear>(touched)) return no_contact();
    return PlainStep::slide(contact, touched, force);
  }
};

// Of a slip: what is kept from before.
template <void (*keep)(const Contact& before, Contact& slid, const StepAsk& ask)>
struct Keeps : PlainStep {
  using PlainStep::PlainStep;
  Contact slid(const Contact& before, Contact landed) const override {
    Contact contact = PlainStep::slid(before, landed);
    keep(before, contact, ask);
    return contact;
  }
};

void normal(const Contact& before, Contact& slid, const StepAsk&) {
  slid.normal_in_world = before.normal_in_world;
}
void friction(const Contact& before, Contact& slid, const StepAsk&) {
  slid.static_friction = before.static_friction;
  slid.dynamic_friction = before.dynamic_friction;
}
void maximum_force(const Contact& before, Contact& slid, const StepAsk&) {
  slid.maximum_force = before.maximum_force;
}
void velocity(const Contact& before, Contact& slid, const StepAsk&) {
  slid.pebble_velocity_in_world = before.pebble_velocity_in_world;
}
void way_for_velocity(const Contact& before, Contact& slid, const StepAsk&) {
  for (std::size_t i = 0; i < 3; ++i) {
    slid.pebble_velocity_in_world[i] = slid.pebble_in_world[i] - before.pebble_in_world[i];
  }
}
void velocity_on_frame(const Contact&, Contact& slid, const StepAsk& ask) {
  for (std::size_t i = 0; i < 3; ++i) slid.pebble_velocity_in_world[i] -= ask.frame.velocity_in_world[i];
}
void old_height(const Contact& before, Contact& slid, const StepAsk&) {
  slid.pebble_in_world[2] = before.pebble_in_world[2];
}

}  // namespace

std::vector<Bug> landing_bugs() {
  using enum Reach;
  constexpr Kind step = Kind::step;
  return {
      {"end-touches", step, tied, "lambda = 1 makes contact", steps<EndTouches>()},
      {"end-touches-in-slip", step, tied, "lambda = 1 keeps contact in a slip", steps<EndTouchesInSlip>()},
      {"stands-at-start", step, tied, "lambda = 0 on a face is contact, not broken", steps<StandsAtStart>()},
      {"steep-landing", step, special, "after a slip the new normal may be steep", steps<SteepLanding>()},
      {"default-steep-landing", step, special, "a new normal is held against the default uprightness",
       steps<DefaultSteepLanding>()},
      {"steep-in-world", step, special, "a new normal is held against the world's z", steps<SteepInWorld>()},
      {"rubber-for-all", step, special, "an unknown tyre is rubber", steps<RubberForAll>()},
      {"strangers-slide", step, special, "an unknown tyre has no friction", steps<NoFrictionForStrangers>()},
      {"landing-normal-in-wheel", step, special, "a new normal is kept in wheel coordinates",
       steps<NormalInWheel>()},
      {"strut-along-world", step, special, "the strut hangs along the world's z", steps<WorldStrut>()},
      {"strut-to-zero", step, special, "the strut ends at z_zero", steps<StrutToZero>()},
      {"slips-at-first", step, special, "a first contact slips", steps<SlipsAtFirst>()},
      {"moves-at-first", step, special, "a first contact moves with the frame", steps<MovesAtFirst>()},
      {"no-return-mapping", step, special, "return-mapping is ignored", steps<OtherPlace<by_springs>>()},
      {"return-mapping-without-h", step, special, "return-mapping forgets h", steps<OtherPlace<without_h>>()},
      {"return-mapping-without-velocity", step, special, "return-mapping forgets the velocity",
       steps<OtherPlace<without_velocity>>()},
      {"relocated-by-k-z", step, special, "a slip is relocated by k_z", steps<ByVerticalSpring>()},
      {"slip-goes-on-in-air", step, special, "a slip off the ground stays a slip", steps<SlipGoesOnInAir>()},
      {"force-lost-in-air", step, special, "a slip off the ground gives no force", steps<ForceLostInAir>()},
      {"keeps-normal", step, special, "a slip keeps its normal", steps<Keeps<normal>>()},
      {"keeps-friction", step, special, "a slip keeps its friction", steps<Keeps<friction>>()},
      {"keeps-maximum-force", step, special, "a slip keeps its maximum force", steps<Keeps<maximum_force>>()},
      {"keeps-velocity", step, special, "a slip keeps its pebble's velocity", steps<Keeps<velocity>>()},
      {"keeps-height", step, special, "a slip keeps its pebble's height in the world",
       steps<Keeps<old_height>>()},
      {"way-for-velocity", step, special, "the pebble's velocity is not divided by h",
       steps<Keeps<way_for_velocity>>()},
      {"velocity-on-frame", step, special, "the pebble's velocity is relative to the frame",
       steps<Keeps<velocity_on_frame>>()},
  };
}

}  // namespace groundtruth::planted
