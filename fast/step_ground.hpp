#pragma once
// What is left of a scene's solid along a strut, for the exact stage. Not installed.

#include <groundtruth/fast/exact_stage/strut.hpp>
#include <groundtruth/fast/undecided.hpp>

namespace groundtruth::fast {

class SolidAlongStrut : public exact_stage::Ground {
 public:
  explicit SolidAlongStrut(const Scene& scene) : scene_(scene) {}

  exact_stage::ExpressionView along(const RangeEnds& ends) override;

 private:
  const Scene& scene_;
  std::optional<Probe> probe_;
  std::optional<OpenSolid> open_;
};

}  // namespace groundtruth::fast
