#include <cmath>
#include <set>
#include <vector>

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

template <class Which>
cases::Case with_numbers(const cases::Case& from, double value, Which is_meant) {
  cases::Case candidate = from;
  std::size_t at = 0;
  for_each_number(candidate, [&](const std::string&, double& number) {
    if (is_meant(at++, number)) number = value;
  });
  return candidate;
}

}  // namespace

bool with_simpler_numbers(const cases::Case& from, const Take& take) {
  std::vector<double> numbers;
  cases::Case copy = from;
  for_each_number(copy, [&](const std::string&, double& number) { numbers.push_back(number); });
  const std::multiset<double> values(numbers.begin(), numbers.end());
  for (auto value = values.begin(); value != values.end(); value = values.upper_bound(*value)) {
    if (values.count(*value) < 2) continue;
    for (const double candidate : simpler(*value))
      if (!take(with_numbers(from, candidate, [&](std::size_t, double number) { return number == *value; })))
        return false;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (const double candidate : simpler(numbers[i]))
      if (!take(with_numbers(from, candidate, [&](std::size_t at, double) { return at == i; }))) return false;
  return true;
}

}  // namespace groundtruth::diagnosis
