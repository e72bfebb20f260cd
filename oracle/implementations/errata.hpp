#pragma once
// The errors of SPEC section 7 that the engine "as-written" can make one by one.

#include <string>
#include <vector>

namespace groundtruth::implementations {

// By name, in the contract's order; make_engine("as-written:NAME") makes this one alone.
std::vector<std::string> erratum_names();

}  // namespace groundtruth::implementations
