#pragma once
// The inner loops over lanes of any kind. Not installed.
//
// Calls nothing but what is inlined or a template over the lanes: what is compiled here for one set of
// instructions must not be linked into code for another.

#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/crossing_body.hpp>

namespace groundtruth::fast {

// Where half-spaces are crossed, a group at a time.
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

  explicit GroupCrosser(const CertifiedEnds& ends)
      : first_x_(Lanes::all(ends.first[0])),
        first_y_(Lanes::all(ends.first[1])),
        first_z_(Lanes::all(ends.first[2])),
        last_x_(Lanes::all(ends.last[0])),
        last_y_(Lanes::all(ends.last[1])),
        last_z_(Lanes::all(ends.last[2])),
        error_(Lanes::all(ends.error)),
        twice_error_(Lanes::all(2 * ends.error)) {}

  // Certainly outside one at both ends: then the cell is missed.
  [[gnu::always_inline]] inline typename Lanes::Choice is_outside(const HalfSpaces4& group) const {
    const Deltas at = deltas(group);
    return lesser(at.first, at.last) > error_;
  }

  [[gnu::always_inline]] inline Crossings cross(const HalfSpaces4& group) const {
    const auto [a, b] = deltas(group);
    const Lanes w = a - b, inverse = Lanes::all(1) / w;
    const Lanes middle = a * inverse, error = error_ * inverse, margin = greater(error, -error);
    return {greater(a, b) < -error_, w > twice_error_, w < -twice_error_, middle - margin, middle + margin};
  }

 private:
  struct Deltas {
    Lanes first, last;
  };

  [[gnu::always_inline]] inline Deltas deltas(const HalfSpaces4& group) const {
    const Lanes x = Lanes::load(group.normal_x);
    const Lanes y = Lanes::load(group.normal_y);
    const Lanes z = Lanes::load(group.normal_z);
    const Lanes offset = Lanes::load(group.offset);
    return {x * first_x_ + y * first_y_ + z * first_z_ - offset,
            x * last_x_ + y * last_y_ + z * last_z_ - offset};
  }

  Lanes first_x_, first_y_, first_z_, last_x_, last_y_, last_z_, error_, twice_error_;
};

// Four half-spaces that are entered (the highest limits) or left (the lowest) abreast.
template <class Lanes>
Meeting meet_groups(const HalfSpaces4* group, const HalfSpaces4* end, const CertifiedEnds& ends) {
  const GroupCrosser<Lanes> crosser(ends);
  // Most cells are missed like this: no need to divide.
  unsigned outside = 0;
  for (const HalfSpaces4* at = group; at != end; ++at) outside |= crosser.is_outside(*at).bits();
  if (outside != 0) return no_meeting;
  const Lanes before_range = Lanes::all(-1), after_range = Lanes::all(2);
  Lanes enter_lower = before_range, enter_upper = before_range, exit_lower = after_range,
        exit_upper = after_range;
  unsigned undecided = 0;
  constexpr unsigned all = (1U << Lanes::width) - 1;
  for (; group != end; ++group) {
    const auto at = crosser.cross(*group);
    undecided |= all & ~(at.enters | at.leaves | at.is_inside).bits();
    enter_lower = greater(choose(at.enters, at.lower, before_range), enter_lower);
    enter_upper = greater(choose(at.enters, at.upper, before_range), enter_upper);
    exit_lower = lesser(choose(at.leaves, at.lower, after_range), exit_lower);
    exit_upper = lesser(choose(at.leaves, at.upper, after_range), exit_upper);
  }
  const double entry = enter_lower.greatest(), lower = entry > 0 ? entry : 0;
  if (lower > 1 || lower > exit_upper.least()) return no_meeting;
  const double upper = enter_upper.greatest(), exit = exit_lower.least();
  const bool is_certain = undecided == 0 && upper <= 1 && upper <= exit && exit > 0;
  return {lower, is_certain ? upper : 2};
}

template <class Lanes>
Touching touching_groups(const HalfSpaces4* group, const HalfSpaces4* end, const CertifiedEnds& ends,
                         const Meeting& meeting) {
  const GroupCrosser<Lanes> crosser(ends);
  const Lanes lower = Lanes::all(meeting.lower), upper = Lanes::all(meeting.upper);
  Touching found;
  for (std::uint32_t first = 0; group != end; ++group, first += Lanes::width) {
    const auto at = crosser.cross(*group);
    const unsigned touches = ((at.enters & (at.upper >= lower)) | (at.leaves & (at.lower <= upper))).bits();
    if (touches == 0) continue;
    found.count += static_cast<std::uint32_t>(__builtin_popcount(touches));
    found.place = first + static_cast<std::uint32_t>(__builtin_ctz(touches));
  }
  return found;
}

// Lemma box-slabs (box_probe.hpp).
template <class FloatLanes>
unsigned meet_eight_boxes(const BoxNode& node, const BoxWay& way, float upper, float* nearest) {
  FloatLanes near = FloatLanes::all(0), far = FloatLanes::all(upper);
  for (int axis = 0; axis < 3; ++axis) {
    const float* const near_sides = way.is_ascending[axis] ? node.low[axis] : node.high[axis];
    const float* const far_sides = way.is_ascending[axis] ? node.high[axis] : node.low[axis];
    const FloatLanes inverse = FloatLanes::all(way.inverse[axis]);
    const FloatLanes stretched = FloatLanes::all(way.inverse[axis] * (1 + 0x1p-20F));
    near = greater((FloatLanes::load(near_sides) - FloatLanes::all(way.near_origin[axis])) * inverse, near);
    far = lesser((FloatLanes::load(far_sides) - FloatLanes::all(way.far_origin[axis])) * stretched, far);
  }
  near.store(nearest);
  return (near <= far).bits();
}

template <class Lanes, class FloatLanes, class Products>
constexpr CellKernels kernels_of{meet_groups<Lanes>, touching_groups<Lanes>, meet_eight_boxes<FloatLanes>,
                                 rounded_crossing_of<Products>};

}  // namespace groundtruth::fast
