#pragma once
// Did two implementations make the same error? Private to this folder.

#include <groundtruth/problem/answer.hpp>

namespace groundtruth::diagnosis {

// Same kinds and faces, and numbers that are a thousand times nearer to each other than `got` is to `exact`,
// or within a few ulps: an error is the same although one made it in doubles and the other did not.
bool resembles(const Answer& suspected, const Answer& got, const Answer& exact);

}  // namespace groundtruth::diagnosis
