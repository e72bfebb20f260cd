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

  // Whether `got` is what one of these would be, but for what the tolerance allows: of the kind of one or
  // more of them, with a face that one of those or the ground nearby has, and with vectors that lie among
  // theirs.
  bool lies_among(const StepAnswer& got, const std::vector<StepAnswer>& explanations) const;

  const StepScales& scales() const { return scales_; }

 private:
  Verdict of_contacts(const Contact& got, const Contact& expected) const;
  long double kept_slack() const;
  long double landing_slack(const Contact& expected) const;
  bool has_face_of(const Contact& got, const Contact& expected) const;
  bool has_face_nearby(const Contact& got, long double distance) const;
  bool is_contact_among(const Contact& got, const std::vector<const Contact*>& expected) const;
  bool is_kept(const Contact& got) const;

  const Truth& truth_;
  const StepAsk& ask_;
  StepScales scales_;
};

}  // namespace groundtruth::judge
