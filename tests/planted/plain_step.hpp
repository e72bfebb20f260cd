#pragma once
// The step of SPEC section 5 as one would write it, on long numbers, each part open to mistakes. It is never
// asked for an answer, only for whether a mistake makes a difference.

#include <optional>

#include "plain_clip.hpp"

namespace groundtruth::planted {

// A contact in wheel coordinates.
struct Seen {
  Numbers pebble, velocity, normal;
};

struct Level {
  Number x, y;
};

// Where a strut meets the ground: nowhere, or only with its end; a reason not to go on; a contact.
struct Clear {};
using Touch = std::variant<Clear, StepFailure, Refusal, Contact>;

class PlainStep {
 public:
  PlainStep(const StepAsk& step_ask, const Right& right_answers)
      : ask(step_ask),
        wheel(step_ask.wheel),
        right(right_answers),
        world_from_wheel(step_ask.frame.world_from_wheel) {}
  virtual ~PlainStep() = default;
  PlainStep(const PlainStep&) = delete;

  StepAnswer take() const;

 protected:
  // From a contact, in the order in which they are called.
  virtual Seen seen(const Contact& contact) const;
  virtual std::optional<StepAnswer> at_limits(const Seen& seen, const Contact& contact) const;
  virtual bool is_upright(const Numbers& normal_in_wheel) const;
  virtual Numbers spring_force(const Seen& seen) const;
  virtual std::optional<StepAnswer> under_pressure(const Number& pressure, const Numbers& force,
                                                   const Contact& contact) const;
  virtual Number friction(const Contact& contact) const;
  virtual Number brake(const Contact& contact) const;
  virtual Vector force_on_frame(const Numbers& clipped_in_wheel) const;
  virtual StepAnswer stay(const Contact& contact, const Vector& force) const;
  virtual Level relocated(const Seen& seen, const Numbers& clipped_in_wheel) const;
  virtual StepAnswer slide(const Contact& contact, const Touch& touch, const Vector& force) const;

  // What a slip's contact becomes; its pebble, normal and material are those where the strut lands.
  virtual Contact slid(const Contact& before, Contact landed) const;

  // A strut at x and y of the wheel.
  virtual EntryAsk strut(const Level& level) const;
  virtual Touch touch(const Level& level) const;
  virtual bool is_end(double lambda) const { return lambda == 1; }
  virtual bool is_start(const EntryAnswer& entry) const;
  virtual bool is_landing_upright(const Numbers& normal_in_wheel) const;
  virtual Touch contact_on(const Border& border) const;
  virtual StepAnswer first_contact(Contact contact) const;

  Numbers to_world(const Numbers& in_wheel) const {
    return numbers(ask.frame.position_in_world) + world_from_wheel(in_wheel);
  }
  static StepAnswer no_contact(const Vector& force = {}) { return Stepped{Free{}, force}; }
  static StepAnswer failure_of(const Touch& touch);
  Numbers arm(const Contact& contact) const {
    return numbers(contact.pebble_in_world) - numbers(ask.frame.position_in_world);
  }

  const StepAsk& ask;
  const Wheel& wheel;
  const Right& right;
  const Turn world_from_wheel;

 private:
  StepAnswer from(const Contact& contact) const;
};

// The wrong step's answer where it differs from the plain one's, else the right answer.
StepAnswer deviation(const Right& right, const StepAsk& ask, const PlainStep& wrong);

template <class Wrong>
Prepare steps() {
  return answers<StepAsk, StepAnswer>(
      [](const StepAsk& ask, const Right& right) { return deviation(right, ask, Wrong(ask, right)); });
}

}  // namespace groundtruth::planted
