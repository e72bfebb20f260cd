#pragma once
// Wrong answers, made from the exact one by a change that nothing excuses.

#include <memory>
#include <string>
#include <vector>

#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::judge {

struct WrongAnswer {
  std::string change;  // what was done to the exact answer: "lambda two ulps late"
  Answer answer;
};

// None of them is right on the canonical leaf, to 1e-9 of any scale. Those of a step may be right on another
// leaf that is admissible where the strut lands: `is_right_on_another_leaf`.
std::vector<WrongAnswer> wrong_answers(const Scene& scene, const Ask& ask,
                                       const implementations::Answered& exact);

// The exact answers, whichever of the faces that meet comes first in the numbering: those of the scene with
// its operands in other orders.
class OtherOrders {
 public:
  explicit OtherOrders(const Scene& scene);
  bool is_right_on_another_leaf(const Ask& ask, const StepAnswer& got) const;

 private:
  std::vector<std::unique_ptr<const implementations::EngineOnScene>> orders_;
};

}  // namespace groundtruth::judge
