#pragma once
// An explanation as a page of text for a terminal.

#include <string>

#include <groundtruth/explanation/explanation.hpp>

namespace groundtruth::page {

enum class Colours { none, ansi };

std::string text_page(const explanation::Explanation& explanation, const std::string& replay_command,
                      Colours colours);

}  // namespace groundtruth::page
