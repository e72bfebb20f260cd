#pragma once
// What a validation comes to.

#include <string>
#include <string_view>
#include <vector>

#include <groundtruth/validation/record.hpp>

namespace groundtruth::validation {

enum class Conclusion { agrees, disagrees, unreadable, broke_down, nothing_judged };

// Known failures do not count. Of the rest the first of these decides: an answer is wrong, or a known
// failure passes or has changed: disagrees; it crashed or hung: broke_down; unreadable; nothing was judged.
Conclusion conclude(const Tally& tally, const std::vector<Record>& records);

std::string_view in_words(Conclusion conclusion);

}  // namespace groundtruth::validation
