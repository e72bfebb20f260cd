#include <cmath>
#include <set>

#include <groundtruth/diagnosis/inputs.hpp>
#include <groundtruth/diagnosis/moves.hpp>
#include <groundtruth/diagnosis/size.hpp>

namespace groundtruth::diagnosis {
namespace {

double with_bits(double number, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  return std::ldexp(std::rint(std::ldexp(mantissa, bits)), exponent - bits);
}

// In the order in which they are worth trying.
std::vector<double> simpler(double number) {
  std::vector<double> result;
  for (const double candidate :
       {0.0, 1.0, -1.0, 2.0, std::rint(number), std::trunc(number / 2), number - std::copysign(1, number),
        -number, with_bits(number, 1), with_bits(number, 3), with_bits(number, 8), with_bits(number, 16),
        with_bits(number, 32), with_bits(number, 48)})
    if (std::isfinite(candidate) && cost_of(candidate) < cost_of(number)) result.push_back(candidate);
  return result;
}

}  // namespace

Cases with_simpler_numbers(const cases::Case& from) {
  Cases result;
  cases::Case copy = from;
  std::multiset<double> values;
  for_each_number(copy, [&](const std::string&, double& number) { values.insert(number); });
  for (auto value = values.begin(); value != values.end(); value = values.upper_bound(*value)) {
    if (values.count(*value) < 2) continue;
    for (const double candidate : simpler(*value)) {
      result.push_back(from);
      for_each_number(result.back(), [&](const std::string&, double& number) {
        if (number == *value) number = candidate;
      });
    }
  }
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t at = 0;
    double value = 0;
    for_each_number(copy, [&](const std::string&, double& number) {
      if (at++ == i) value = number;
    });
    for (const double candidate : simpler(value)) {
      result.push_back(from);
      at = 0;
      for_each_number(result.back(), [&](const std::string&, double& number) {
        if (at++ == i) number = candidate;
      });
    }
  }
  return result;
}

}  // namespace groundtruth::diagnosis
