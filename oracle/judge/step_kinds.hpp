#pragma once
// Which kind of answer a step's is, and what stands in a contact. Private to this folder.

#include <optional>
#include <string>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

#include "leaves.hpp"

namespace groundtruth::judge {

// Null if there is none.
const Contact* contact_in(const StepAnswer& answer);

// The same outcome, state and grip; reasons for refusals do not matter.
bool are_of_one_kind(const StepAnswer& a, const StepAnswer& b);

// Each coefficient, and the maximum force if there is one, to this relative tolerance.
bool has_friction_of(const Contact& got, const Contact& expected, double relative);

// A contact with the friction of this material; absent if the tyre has none on it.
std::optional<Contact> contact_of(const Scene& scene, const MaterialOrNone& material,
                                  const std::string& tyre);

}  // namespace groundtruth::judge
