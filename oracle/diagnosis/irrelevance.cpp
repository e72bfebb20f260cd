#include <groundtruth/diagnosis/irrelevance.hpp>

#include <algorithm>
#include <map>
#include <set>

#include <groundtruth/diagnosis/inputs.hpp>

namespace groundtruth::diagnosis {
namespace {

using Cases = std::vector<cases::Case>;

// Other values of one number, as far as they may be asked.
Cases with_other_values(const cases::Case& from, const std::string& name, double value) {
  Cases result;
  std::set<double> others{0.0,       1.0,       -1.0,           2.0,    value + 0.375, value - 0.625,
                          value * 2, value / 2, value * 1.0625, -value, value - 3};
  others.erase(value);
  for (const double other : others) {
    cases::Case candidate = from;
    for_each_number(candidate, [&](const std::string& at, double& number) {
      if (at == name) number = other;
    });
    if (is_well_formed(candidate)) result.push_back(std::move(candidate));
  }
  return result;
}

std::string vector_of(const std::string& name) { return name.substr(0, name.find('[')); }

// "from[0]", "from[1]", "from[2]" is "from" where the case has no other coordinate of it.
std::vector<std::string> gathered(const std::vector<std::string>& names,
                                  const std::vector<std::string>& all) {
  std::map<std::string, std::size_t> coordinates, free;
  for (const std::string& name : all) ++coordinates[vector_of(name)];
  for (const std::string& name : names) ++free[vector_of(name)];
  std::vector<std::string> result;
  for (const std::string& name : names) {
    const std::string whole = vector_of(name);
    const std::string& shown = free[whole] == coordinates[whole] ? whole : name;
    if (std::find(result.begin(), result.end(), shown) == result.end()) result.push_back(shown);
  }
  return result;
}

}  // namespace

std::vector<std::string> inputs_that_do_not_matter(const cases::Case& failing, const StillFail& still_fail) {
  constexpr std::size_t fewest_values = 3;
  constexpr std::size_t most_names = 100;
  const std::vector<std::string> all = names_of_numbers(failing);
  if (all.size() > most_names) return {};
  std::vector<std::string> result;
  cases::Case copy = failing;
  for_each_number(copy, [&](const std::string& name, double& number) {
    const Cases others = with_other_values(failing, name, number);
    if (others.size() < fewest_values) return;
    const std::vector<bool> fails = still_fail(others);
    if (std::all_of(fails.begin(), fails.end(), [](bool one) { return one; })) result.push_back(name);
  });
  return gathered(result, all);
}

}  // namespace groundtruth::diagnosis
