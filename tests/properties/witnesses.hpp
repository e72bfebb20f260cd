#pragma once
// Both engines behind one door: whatever a law asks, `exact` and `definition` must say the same, answer and
// evidence, or Disagreement is thrown with the lines that replay it.

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <groundtruth/definition/scene.hpp>
#include <groundtruth/exact/scene.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/tests/properties/membership.hpp>

namespace groundtruth::properties {

class Disagreement : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The scene line and the ask line for `groundtruth answer --engine exact`.
std::string replay(const Scene& scene, const Ask& ask);

// What is said to an entry ask.
struct Entered {
  EntryAnswer answer;
  std::optional<Rational> lambda;  // exact; absent: a miss
  std::vector<Leaf> admissible;

  bool is_miss() const { return std::holds_alternative<Miss>(answer); }
  bool is_inside() const { return std::holds_alternative<Inside>(answer); }
  bool is_border() const { return std::holds_alternative<Border>(answer); }
  const Border& border() const { return std::get<Border>(answer); }
};
bool operator==(const Entered& left, const Entered& right);
std::ostream& operator<<(std::ostream& out, const Entered& entered);

// The same lambda, and the same of miss, inside and border.
bool same_place(const Entered& left, const Entered& right);

// Which palette of materials the shapes of these tests refer to: "dry", "metal-only", "soft" (gives way at 6
// N) and "ice" (static 0.25, dynamic 0).
std::vector<Material> palette();

// A scene, prepared once.
class Ground {
 public:
  explicit Ground(Scene scene);
  explicit Ground(Shape shape) : Ground(Scene{palette(), std::move(shape)}) {}

  const Scene& scene() const { return scene_; }
  Entered entry(const EntryAsk& ask) const;
  StepAnswer step(const StepAsk& ask) const;

 private:
  Scene scene_;
  exact::Scene exact_;
  definition::Scene definition_;
};

ClipAnswer clip(const ClipAsk& ask);

}  // namespace groundtruth::properties
