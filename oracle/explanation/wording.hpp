#pragma once
// Answers in words. Private to this folder.

#include <string>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::explanation {

std::string in_words(const Answer& answer, const Evidence& evidence, const Scene& scene);

// "free", "stick", "slip", "wheel broken", "refused", ...
std::string end_in_words(const StepAnswer& answer);

}  // namespace groundtruth::explanation
