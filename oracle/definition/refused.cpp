#include <groundtruth/definition/nearest_double.hpp>
#include <groundtruth/definition/refused.hpp>

namespace groundtruth::definition {

double rounded(const Real& exact, const std::string& quantity) {
  const std::optional<double> result = nearest_double(exact);
  if (!result) throw Refused(quantity + " leaves the range of doubles");
  return *result;
}

Vector rounded(const Triple<Real>& exact, const std::string& quantity) {
  return {rounded(exact[0], quantity + "[0]"), rounded(exact[1], quantity + "[1]"),
          rounded(exact[2], quantity + "[2]")};
}

}  // namespace groundtruth::definition
