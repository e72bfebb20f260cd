#pragma once
// The doubles nearest to exact numbers: ties to even, subnormal ones included. Not installed.

#include <optional>

#include <groundtruth/fast/exact_stage/surd.hpp>

namespace groundtruth::fast::exact_stage {

// The double nearest to numerator / denominator; nothing if that would be an infinity. A result of zero is
// +0. Requires denominator > 0.
std::optional<double> nearest_double(const Dyadic& numerator, const Dyadic& denominator);

// The same for (a + b sqrt(A) + c sqrt(D)) / denominator.
std::optional<double> nearest_double(const Surd& numerator, const Radicands& roots,
                                     const Dyadic& denominator);

}  // namespace groundtruth::fast::exact_stage
