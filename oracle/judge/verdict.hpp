#pragma once
// Is an answer right? SPEC section 6: held against the exact answer, with a tolerance that is exact itself.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <groundtruth/judge/difference.hpp>
#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::judge {

// Which faces of those that meet at the point may be named.
enum class Faces { any_admissible, canonical };

struct Tolerance {
  double metres = 0;       // tau: every half-space may be grown or shrunk by this much
  double lambda_ulps = 1;  // beyond what tau allows
  double normal_angle =
      0x1p-50;                   // radians, of a normal against its leaf's: normalising in doubles costs less
  double relative_decision = 0;  // of clip and step: each decision within this of its scale
  double relative_number = 0;    // of clip and step: each vector, against its largest term
  Faces faces = Faces::any_admissible;
};

// A tolerance with a name for people: "exact" (the default), "double", "float", "game".
struct Profile {
  std::string_view name;
  std::string_view stands_for;  // one line
  Tolerance tolerance;
};

const std::vector<Profile>& profiles();
const Profile* find_profile(std::string_view name);  // null: there is none of this name

struct Verdict {
  Difference difference = Difference::none;  // none: accepted
  Answer exact;                              // what the exact engine answers
  Evidence evidence;
  std::string explanation;  // one line: got -> expected, and how far off; empty if accepted
  double lambda_ulps = 0;   // how far off, where that can be said; else 0
  double metres = 0;
  double newtons = 0;

  bool is_accepted() const { return difference == Difference::none; }
};

// Judges answers about one scene. Several threads may ask at once.
class Judge {
 public:
  Judge(const Scene& scene, const Tolerance& tolerance);
  Judge(Judge&&) noexcept;
  ~Judge();

  // `got` answers `ask`; a Refusal may stand for any kind of ask. A number that is not finite is wrong.
  Verdict judge(const Ask& ask, const Answer& got) const;

 private:
  class Scales;
  std::unique_ptr<const Scales> scales_;
};

}  // namespace groundtruth::judge
