#pragma once
// Classic slips as changes around the exact engine. Private to this folder.

#include <span>
#include <string_view>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::diagnosis {

// What the implementation takes for the ask and the scene.
struct AskSlip {
  std::string_view name;
  std::string_view explanation;
  void (*change)(Scene&, Ask&);
};

// What it makes of the right answer.
struct AnswerSlip {
  std::string_view name;
  std::string_view explanation;
  void (*change)(Answer&, const Ask&);
};

std::span<const AskSlip> ask_slips();
std::span<const AnswerSlip> answer_slips();

}  // namespace groundtruth::diagnosis
