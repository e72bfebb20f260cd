#pragma once
// The clip of SPEC section 4 as one would write it, on long numbers, each part open to mistakes. It is never
// asked for an answer, only for whether a mistake makes a difference.

#include "ways.hpp"

namespace groundtruth::planted {

// A force as the surface sees it, and what holds the pebble.
struct Grasp {
  Numbers force_in_wheel;
  Numbers force_on_surface;  // F'
  Number radius;             // mu N
  Number brake;              // B
};

class PlainClip {
 public:
  struct Axes {
    Numbers x, y, z;  // of the surface, in wheel coordinates
  };
  struct Tangential {
    Number x, y;
  };
  struct Outcome {
    Grip grip = Grip::stick;
    Numbers force_in_wheel;
  };

  virtual ~PlainClip() = default;

  virtual bool is_upright(const Numbers& normal, const Number& min_uprightness) const;
  Outcome clip(const Numbers& force, const Numbers& normal, const Number& friction,
               const Number& brake) const;

 protected:
  virtual Axes axes(const Numbers& normal) const;
  // N, of a force in wheel coordinates and as the surface sees it.
  virtual Number pressure(const Numbers& force, const Numbers& force_on_surface, const Numbers& normal) const;
  virtual bool sticks(const Grasp& grasp) const;
  // H, of a force beyond the border.
  virtual Tangential slide(const Grasp& grasp) const;
  virtual Numbers in_wheel(const Axes& axes, const Numbers& force_on_surface) const;

  static bool is_in_band(const Grasp& grasp);
  static bool is_in_disc(const Grasp& grasp);
  static Tangential at_corner(const Grasp& grasp);
  static Tangential on_disc(const Grasp& grasp);
  static Number with_sign_of(const Number& signed_number, const Number& size);
  // sqrt((mu N)^2 - B^2), 0 where that is negative.
  static Number half_chord(const Grasp& grasp);
};

// The wrong clip's answer where it differs from the plain one's, else the right answer.
ClipAnswer deviation(const Right& right, const ClipAsk& ask, const PlainClip& wrong);

template <class Wrong>
Prepare clips() {
  return answers<ClipAsk, ClipAnswer>(
      [](const ClipAsk& ask, const Right& right) { return deviation(right, ask, Wrong()); });
}

bool is_finite(const Vector& vector);

}  // namespace groundtruth::planted
