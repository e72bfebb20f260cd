#pragma once
// What doubles left undecided, handed to the exact stage. Not installed.

#include <optional>

#include <boost/container/small_vector.hpp>
#include <groundtruth/fast/crossing.hpp>
#include <groundtruth/fast/exact_stage/entry.hpp>
#include <groundtruth/fast/search.hpp>

namespace groundtruth::fast {

// The union of some contenders, without the half-spaces that cannot matter where their first points lie.
class OpenSolid {
 public:
  OpenSolid(const Scene& scene, const Probe& probe) : scene_(scene), probe_(probe) {}

  // `upper`: of the s at which the union is met, if it is.
  void assemble(const Contender* first, const Contender* end, double upper);

  exact_stage::ExpressionView view() const {
    return {
        {nodes_.data(), nodes_.size()}, {leaves_.data(), leaves_.size()}, {numbers_.data(), numbers_.size()}};
  }
  Leaf number(std::size_t place) const { return numbers_[place]; }
  const HalfSpace& leaf(std::size_t place) const { return leaves_[place]; }
  // Of the first point of its view.
  RoundedLambda lambda(const exact_stage::FirstPoint& point, const EntryAsk& ask) const;

 private:
  void add_cell(const Contender& contender, double upper);
  void add_general(const Contender& contender);
  std::uint32_t add_leaf(Leaf number, const HalfSpace& half_space);

  const Scene& scene_;
  const Probe& probe_;
  boost::container::small_vector<Node, 64> nodes_;
  boost::container::small_vector<HalfSpace, 64> leaves_;
  boost::container::small_vector<Leaf, 64> numbers_;
};

struct ExactEntry {
  RoundedLambda lambda;              // stage none: it is the range's first
  Leaf leaf = no_leaf;               // no_leaf: the range starts in the interior
  HalfSpace half_space;              // the leaf's
  std::optional<HalfSpace> crossed;  // absent: lambda is the range's first
};

// The exact answer of a search that has contenders; nothing: a miss. Lowers result.upper if it learns more.
std::optional<ExactEntry> decide(const Scene& scene, const Probe& probe, const EntryAsk& ask,
                                 SearchResult& result);

}  // namespace groundtruth::fast
