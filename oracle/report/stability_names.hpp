#pragma once
// Words for what a stability map varies. Private to this folder.

#include <string>
#include <string_view>

#include <groundtruth/stability/parked.hpp>

namespace groundtruth::report {

int count_of(stability::Wheels wheels);
std::string_view name_of(Relocation relocation);

// All but h omega and damping.
std::string panel_name(const stability::Parked& parked);

}  // namespace groundtruth::report
