#pragma once
// The same asks, answered by every kind of arithmetic that one might use for them. A tier is a real
// implementation of the contract; what tells one from another is its numbers.

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <groundtruth/problem/answer.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::tiers {

enum class AskKind { entry, clip, step };

AskKind kind_of(const Ask& ask);

// The arithmetic knows bounds only, and they do not tell which of several answers is right.
struct Undecided {};

// This tier does not answer asks of this kind.
struct Omitted {
  std::string reason;  // one line
};

using TierAnswer = std::variant<Answer, Undecided>;

// A tier with a scene prepared. Not for several threads at once.
class TierOnScene {
 public:
  virtual ~TierOnScene() = default;
  // Whatever the ask, an answer comes; that of plain floating point may be wrong, and may hold NaN or
  // infinities. Requires that the tier does not omit asks of this kind.
  virtual TierAnswer answer(const Ask& ask) const = 0;
};

class Tier {
 public:
  virtual ~Tier() = default;
  virtual std::string name() const = 0;         // "float", "mpfr-128", "fast", ...
  virtual std::string description() const = 0;  // one line
  virtual std::optional<Omitted> omission(AskKind kind) const = 0;
  virtual std::unique_ptr<const TierOnScene> on(const Scene& scene) const = 0;
};

// From little precision to much, the engines of this program after the plain arithmetics: float, double,
// as-written, fast, long-double, double-double, interval, cpp_bin_float_50, mpfr-128, mpfr-256, cgal-lazy,
// exact, definition.
const std::vector<std::unique_ptr<const Tier>>& tiers();

// What every tier says of one ask, in the order of tiers().
struct Row {
  std::string name;
  std::string description;
  std::variant<Answer, Undecided, Omitted> said;
};
std::vector<Row> rows_for(const Scene& scene, const Ask& ask);

}  // namespace groundtruth::tiers
