#pragma once
// Generators of shapes, asks and numbers for the laws. Values shrink by themselves (shrinking.hpp): to few
// leaves and small whole numbers. What a counterexample prints is a scene line and an ask line to replay.

#include <iosfwd>

#include <rapidcheck.h>

#include <groundtruth/problem/ask.hpp>
#include <groundtruth/problem/scene.hpp>
#include <groundtruth/tests/properties/dice.hpp>

namespace groundtruth::properties {

// A shape over the palette of witnesses.hpp, and a question to it.
struct EntryCase {
  Shape shape;
  EntryAsk ask;
};
struct StepCase {
  Shape shape;
  StepAsk ask;
};
void showValue(const EntryCase& c, std::ostream& out);
void showValue(const StepCase& c, std::ostream& out);

}  // namespace groundtruth::properties

namespace groundtruth {
void showValue(const ClipAsk& ask, std::ostream& out);
}

namespace groundtruth::properties {

// Any finite double by its bits: subnormals, zeros of both signs, powers of two and their neighbours, the
// whole range of exponents, and small whole numbers.
double any_double(Dice& dice);
// `value`, or a double a few ulps from it, or, once in `odd_one_in` times, any double.
double wobbled(double value, Dice& dice, int odd_one_in);

// Nested, all operators, paints, copies of parts, sheets of opposite half-spaces, zero normals; small whole
// numbers. Nothing overflows or rounds in a law that multiplies these numbers by less than 2^20.
Shape lattice_shape(Dice& dice, int depth);
Vector lattice_vector(Dice& dice, int largest);
Vector lattice_normal(Dice& dice);
// A segment aimed at where planes of the shape meet: along them, through them, ending on them, of no length;
// the range is of multiples of 1/4, not always in [0, 1].
EntryAsk lattice_ask(const Shape& shape, Dice& dice);

rc::Gen<EntryCase> lattice_entries();
// The same with normals of -1, 0, 1 only.
rc::Gen<EntryCase> cubic_entries();
// Lattice cases with some numbers a few ulps off, or any doubles at all.
rc::Gen<EntryCase> wild_entries();

// Small whole numbers.
rc::Gen<ClipAsk> lattice_clips();
// Exactly on the borders between stick and the cases of slip, or a few ulps beside them.
rc::Gen<ClipAsk> border_clips();
// Any doubles.
rc::Gen<ClipAsk> wild_clips();

// A wheel near a few faces, numbers small and whole, so that every boundary of SPEC section 5 is hit with
// equality.
rc::Gen<StepCase> lattice_steps();
rc::Gen<StepCase> wild_steps();

}  // namespace groundtruth::properties
