#pragma once
// How a result that cannot be given stops the evaluation (SPEC section 5); caught where the answer is made.

#include <stdexcept>
#include <string>

#include <groundtruth/definition/real.hpp>

namespace groundtruth::definition {

class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The nearest double. Throws Refused, naming the quantity, if it is outside the range of doubles.
double rounded(const Real& exact, const std::string& quantity);

// The same of the three coordinates "quantity[0]" to "quantity[2]".
Vector rounded(const Triple<Real>& exact, const std::string& quantity);

}  // namespace groundtruth::definition
