#pragma once
// Wrong answers, a file a kind of ask. Private to these tests.

#include "wrong_answers.hpp"

namespace groundtruth::judge {

std::vector<HalfSpace> leaves_in_order(const Shape& shape);

std::vector<WrongAnswer> wrong_entries(const Scene& scene, const EntryAsk& ask, const EntryAnswer& exact,
                                       const std::vector<Leaf>& admissible);
std::vector<WrongAnswer> wrong_clips(const ClipAsk& ask, const ClipAnswer& exact);
std::vector<WrongAnswer> wrong_steps(const StepAsk& ask, const StepAnswer& exact);

// The vector with one component changed by `change`, three ways; and with the sign of each component flipped
// that is larger than `change`.
std::vector<Vector> nearby(const Vector& vector, double change);
std::vector<Vector> flipped(const Vector& vector, double change);

double size_of(const Vector& vector);

}  // namespace groundtruth::judge
