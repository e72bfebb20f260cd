#pragma once
// How a verdict is told: "got -> expected, how far off". Private to this folder.

#include <string>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

#include "truth.hpp"

namespace groundtruth::judge {

std::string words(double value);                     // "0.5 (0x1p-1)"
std::string words(const Vector& vector);             // "[0, 0, 1]"
std::string words(Grip grip);                        // "slip"
std::string words(StepFailure failure);              // "wheel_broken"
std::string words_of_lambda(const Answered& exact);  // "1/4 (0x1p-2)"
std::string words(const MaterialOrNone& material, const Scene& scene);
std::string words_of_leaves(const std::vector<Leaf>& leaves);  // "leaf 3 or 5"
std::string short_number(double value);                        // three digits

// What an answer is, without its numbers: "miss", "border on leaf 3", "ok, slip", "refusal (...)".
std::string kind_in_words(const Answer& answer);

}  // namespace groundtruth::judge
