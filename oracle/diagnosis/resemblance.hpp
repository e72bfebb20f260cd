#pragma once
// Did two implementations make the same error? Private to this folder.

#include <groundtruth/problem/answer.hpp>

namespace groundtruth::diagnosis {

// Same kinds and faces, and numbers that are a thousand times nearer to each other than `got` is to `exact`,
// or within a few ulps but nearer to each other than to `exact`: an error is the same although one made it in
// doubles and the other did not.
bool shares_error(const Answer& suspected, const Answer& got, const Answer& exact);

// Same kinds and faces, and numbers within a few ulps.
bool resembles(const Answer& suspected, const Answer& got);

}  // namespace groundtruth::diagnosis
