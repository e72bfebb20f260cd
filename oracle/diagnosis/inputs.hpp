#pragma once
// The inputs of a case by name: "range[0]", "wheel.k_xy", "state.pebble[2]", "leaf 3 offset".

#include <functional>
#include <string>
#include <vector>

#include <groundtruth/cases/case.hpp>

namespace groundtruth::diagnosis {

// Calls visit(name, number) for each number of the ask, then of the scene's half-spaces (leaves by number,
// those of paint regions as "region").
void for_each_number(cases::Case& with, const std::function<void(const std::string&, double&)>& visit);

std::vector<std::string> names_of_numbers(const cases::Case& with);

// Is the case what SPEC sections 1 to 5 allow to be asked?
bool is_well_formed(const cases::Case& with);

}  // namespace groundtruth::diagnosis
