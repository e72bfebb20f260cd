#pragma once
// A step's answer against one that explains it. Private to this folder.

#include <vector>

#include "step_scales.hpp"
#include "truth.hpp"

namespace groundtruth::judge {

class StepMatch {
 public:
  StepMatch(const Truth& truth, const StepAsk& ask) : truth_(truth), ask_(ask), scales_(scales_of(ask)) {}

  // The first difference, with its explanation.
  Verdict against(const StepAnswer& got, const StepAnswer& expected) const;

  // Whether `got` is what some of these would be: of the kind of one or more of them, with the normal and
  // friction of one of those, and with vectors that lie among theirs, but for what the tolerance allows.
  // `newtons` and `metres` are what the answers themselves lie apart by.
  bool lies_among(const StepAnswer& got, const std::vector<StepAnswer>& explanations, long double newtons,
                  long double metres) const;

  const StepScales& scales() const { return scales_; }

 private:
  Verdict of_contacts(const Contact& got, const Contact& expected) const;
  bool has_face_of(const Contact& got, const Contact& expected) const;

  const Truth& truth_;
  const StepAsk& ask_;
  StepScales scales_;
};

}  // namespace groundtruth::judge
