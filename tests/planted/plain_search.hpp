#pragma once
// Φ as one would write it in doubles, each step open to mistakes. It rounds, so it is never asked for an
// answer, only for whether a mistake makes a difference.

#include <optional>
#include <span>

#include "ways.hpp"

namespace groundtruth::planted {

// top / bottom, bottom > 0. Not divided, so that short numbers stay exact.
struct Ratio {
  double top = 0;
  double bottom = 1;
};
inline bool operator<(const Ratio& a, const Ratio& b) { return a.top * b.bottom < b.top * a.bottom; }

struct Hit {
  Ratio lambda;
  const HalfSpace* face = nullptr;  // null: inside
};

class PlainSearch {
 public:
  explicit PlainSearch(const EntryAsk& ask) : ask_(ask), last_{ask.lambda_last, 1} {}
  virtual ~PlainSearch() = default;

  std::optional<Hit> search(const Shape& shape) { return first(shape, {ask_.lambda_first, 1}); }
  // Rounds within rounds of deeply nested intersections take for ever: then the search is given up.
  bool has_given_up() const { return visits_ > most_visits; }

 protected:
  // The first point of the shape from `start` on.
  std::optional<Hit> first(const Shape& shape, const Ratio& start);
  virtual std::optional<Hit> first_of_half_space(const HalfSpace& half_space, const Ratio& start);
  virtual std::optional<Hit> first_of_union(std::span<const Shape> operands, const Ratio& start);
  virtual std::optional<Hit> first_of_intersection(std::span<const Shape> operands, const Ratio& start);
  virtual double distance(const HalfSpace& half_space, const Vector& point) const;

  const EntryAsk& ask() const { return ask_; }
  const Ratio& last() const { return last_; }

 private:
  EntryAsk ask_;
  static constexpr unsigned most_visits = 100000;

  Ratio last_;
  unsigned visits_ = 0;
};

// The wrong search's answer where it differs from the plain one's, else the right answer.
EntryAnswer deviation(const Right& right, const EntryAsk& ask, PlainSearch& wrong);

template <class Wrong>
Prepare searches() {
  return answers<EntryAsk, EntryAnswer>([](const EntryAsk& ask, const Right& right) {
    Wrong wrong(ask);
    return deviation(right, ask, wrong);
  });
}

}  // namespace groundtruth::planted
