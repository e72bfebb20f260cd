#pragma once
// The inner loops over lanes of any kind. Not installed.
//
// Calls nothing but what is inlined or a template over the lanes: what is compiled here for one set of
// instructions must not be linked into code for another.

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/crossing_body.hpp>

namespace groundtruth::fast {

template <class Lanes>
struct Deltas {
  Lanes first, last;
};

// The ends of a range, for a group of half-spaces at a time.
template <class Lanes>
class EndLanes {
 public:
  EndLanes(const double* first, const double* last)
      : first_x_(Lanes::all(first[0])),
        first_y_(Lanes::all(first[1])),
        first_z_(Lanes::all(first[2])),
        last_x_(Lanes::all(last[0])),
        last_y_(Lanes::all(last[1])),
        last_z_(Lanes::all(last[2])) {}

  [[gnu::always_inline]] inline Deltas<Lanes> deltas(const HalfSpaces4& group) const {
    const Lanes x = Lanes::load(group.normal_x);
    const Lanes y = Lanes::load(group.normal_y);
    const Lanes z = Lanes::load(group.normal_z);
    const Lanes offset = Lanes::load(group.offset);
    return {x * first_x_ + y * first_y_ + z * first_z_ - offset,
            x * last_x_ + y * last_y_ + z * last_z_ - offset};
  }

 private:
  Lanes first_x_, first_y_, first_z_, last_x_, last_y_, last_z_;
};

// Where half-spaces are crossed, if every Delta is within an error bound (lemma clip-interval, cell.hpp).
template <class Lanes>
class GroupCrosser {
 public:
  // Each within its limits where `enters` or `leaves` certainly hold.
  struct Crossings {
    typename Lanes::Choice is_inside;  // certainly, at both ends
    typename Lanes::Choice enters;
    typename Lanes::Choice leaves;
    Lanes lower;
    Lanes upper;
  };

  explicit GroupCrosser(double error) : error_(Lanes::all(error)), twice_error_(Lanes::all(2 * error)) {}

  // Certainly outside one at both ends: then the cell is missed.
  [[gnu::always_inline]] inline typename Lanes::Choice is_outside(const Deltas<Lanes>& at) const {
    return lesser(at.first, at.last) > error_;
  }

  [[gnu::always_inline]] inline Crossings cross(const Deltas<Lanes>& at) const {
    const auto [a, b] = at;
    const Lanes w = a - b, inverse = Lanes::all(1) / w;
    const Lanes middle = a * inverse, error = error_ * inverse, margin = greater(error, -error);
    return {greater(a, b) < -error_, w > twice_error_, w < -twice_error_, middle - margin, middle + margin};
  }

 private:
  Lanes error_, twice_error_;
};

// What the crossings of some groups say of their intersection: four half-spaces that are entered (the highest
// limits) or left (the lowest) abreast.
template <class Lanes>
class GroupsMet {
 public:
  [[gnu::always_inline]] inline void add(const typename GroupCrosser<Lanes>::Crossings& at, double number) {
    constexpr unsigned all = (1U << Lanes::width) - 1;
    undecided_ |= all & ~(at.enters | at.leaves | at.is_inside).bits();
    const Lanes upper = choose(at.enters, at.upper, before_range_);
    second_enter_upper_ = greater(lesser(upper, enter_upper_), second_enter_upper_);
    number_ = choose(upper > enter_upper_, Lanes::all(number), number_);
    enter_upper_ = greater(upper, enter_upper_);
    enter_lower_ = greater(choose(at.enters, at.lower, before_range_), enter_lower_);
    exit_lower_ = lesser(choose(at.leaves, at.lower, after_range_), exit_lower_);
    exit_upper_ = lesser(choose(at.leaves, at.upper, after_range_), exit_upper_);
  }

  [[gnu::always_inline]] inline Meeting meeting(double latest) const {
    const double entry = enter_lower_.greatest(), lower = entry > 0 ? entry : 0;
    if (lower > latest || lower > exit_upper_.least()) return no_meeting;
    const double upper = enter_upper_.greatest(), exit = exit_lower_.least();
    if (undecided_ != 0 || !(upper <= 1 && upper <= exit && exit > 0)) return {lower, 2, no_place};
    return {lower, upper, lower > 0 && upper < exit ? sole_place(lower) : no_place};
  }

 private:
  // Of the one half-space entered no earlier than `lower`.
  [[gnu::always_inline]] inline std::uint32_t sole_place(double lower) const {
    const Lanes limit = Lanes::all(lower);
    const unsigned touching = (enter_upper_ >= limit).bits();
    if ((touching & (touching - 1)) != 0 || (second_enter_upper_ >= limit).bits() != 0) return no_place;
    const int lane = __builtin_ctz(touching);
    double numbers[Lanes::width];
    number_.store(numbers);
    return static_cast<std::uint32_t>(Lanes::width * static_cast<int>(numbers[lane]) + lane);
  }

  Lanes before_range_ = Lanes::all(-1), after_range_ = Lanes::all(2);
  Lanes enter_lower_ = before_range_, enter_upper_ = before_range_, second_enter_upper_ = before_range_;
  Lanes exit_lower_ = after_range_, exit_upper_ = after_range_;
  Lanes number_ = Lanes::all(0);  // of the group that is entered last, by lane
  unsigned undecided_ = 0;
};

// What meet_groups() says of a cell of one half-space, the first of the group.
[[gnu::always_inline]] inline Meeting meet_half_space(const HalfSpaces4& group, const double* first,
                                                      const double* last, double error, double latest) {
  const double x = group.normal_x[0], y = group.normal_y[0], z = group.normal_z[0], d = group.offset[0];
  const double a = x * first[0] + y * first[1] + z * first[2] - d;
  const double b = x * last[0] + y * last[1] + z * last[2] - d;
  if (a > error && b > error) return no_meeting;
  const double w = a - b, inverse = 1 / w, middle = a * inverse;
  const double margin = error * __builtin_fabs(inverse);
  if (w > 2 * error) {
    const double lower = middle - margin, upper = middle + margin;
    if (lower > latest) return no_meeting;
    if (!(lower > 0)) return {0, upper <= 1 ? (upper > -1 ? upper : -1) : 2, no_place};
    return upper <= 1 ? Meeting{lower, upper, 0} : Meeting{lower, 2, no_place};
  }
  if (w < -2 * error) {
    if (middle + margin < 0) return no_meeting;
    return {0, middle - margin > 0 ? -1.0 : 2.0, no_place};
  }
  return {0, a < -error && b < -error ? -1.0 : 2.0, no_place};
}

// Before anything is divided, or laid out for it: most cells are missed.
template <class Lanes>
[[gnu::always_inline]] inline Meeting meet_two_groups(const HalfSpaces4* groups, const EndLanes<Lanes>& ends,
                                                      double error, double latest) {
  const auto one = ends.deltas(groups[0]), other = ends.deltas(groups[1]);
  const GroupCrosser<Lanes> crosser(error);
  if ((crosser.is_outside(one) | crosser.is_outside(other)).bits() != 0) return no_meeting;
  GroupsMet<Lanes> met;
  met.add(crosser.cross(one), 0);
  met.add(crosser.cross(other), 1);
  return met.meeting(latest);
}

template <class Lanes>
[[gnu::noinline]] Meeting meet_any_groups(const HalfSpaces4* group, const HalfSpaces4* end,
                                          const EndLanes<Lanes>& ends, double error, double latest) {
  const GroupCrosser<Lanes> crosser(error);
  GroupsMet<Lanes> met;
  for (double number = 0; group != end; ++group, ++number) {
    const auto at = ends.deltas(*group);
    if (crosser.is_outside(at).bits() != 0) return no_meeting;
    met.add(crosser.cross(at), number);
  }
  return met.meeting(latest);
}

// Most cells have two groups. Requires a usable error bound. A meeting behind `latest` may be told as a miss.
template <class Lanes>
[[gnu::always_inline]] inline Meeting meet_groups(const HalfSpaces4* group, const HalfSpaces4* end,
                                                  const EndLanes<Lanes>& ends, double error, double latest) {
  if (end - group == 2) return meet_two_groups(group, ends, error, latest);
  return meet_any_groups(group, end, ends, error, latest);
}

}  // namespace groundtruth::fast
