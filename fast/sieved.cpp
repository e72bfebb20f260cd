#include <groundtruth/fast/sieved.hpp>

#include <cmath>
#include <optional>

#include <groundtruth/fast/evaluate.hpp>
#include <groundtruth/fast/first_place.hpp>

namespace groundtruth::fast {

namespace {

// The leaves of an expression that a range leaves open.
class LeavesOfRange {
 public:
  LeavesOfRange(const Expression& expression, const Probe& probe, OpenLeaves& open)
      : expression_(expression), probe_(probe), open_(open) {}

  // Lemma clip-interval, as in cell.cpp.
  Truth add(std::uint32_t leaf) {
    const auto& [n, d] = expression_.leaves[leaf];
    const double error =
        probe_.error_bound((std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2])) * (1 + 0x1p-50), std::abs(d));
    OpenLeaf open{.leaf = leaf};
    if (error < greatest_usable_error) {
      const Vector &x = probe_.ends().first, &y = probe_.ends().last;
      const double a = n[0] * x[0] + n[1] * x[1] + n[2] * x[2] - d;
      const double b = n[0] * y[0] + n[1] * y[1] + n[2] * y[2] - d;
      if (a < -error && b < -error) return Truth::yes;
      if (a > error && b > error) return Truth::no;
      open = open_leaf(leaf, a, b, error);
    }
    open_.push_back(open);
    return Truth::open;
  }
  std::size_t size() const { return open_.size(); }
  void resize(std::size_t size) { open_.resize(size); }

 private:
  const Expression& expression_;
  const Probe& probe_;
  OpenLeaves& open_;
};

enum class Reading { grown, shrunk };

// Cells with every error to their advantage, or against it.
template <Reading reading>
class CellsAsRead {
 public:
  using Place = double;

  explicit CellsAsRead(const OpenLeaves& leaves) : leaves_(leaves) {}

  static int compare(double a, double b) { return a > b ? 1 : a < b ? -1 : 0; }

  std::optional<double> first_in(const Node& cell, double first, double last) const {
    for (std::uint32_t place = cell.first_leaf; place != cell.end_leaf; ++place) {
      const OpenLeaf& leaf = leaves_[place];
      if (leaf.turn == Turn::enters)
        first = std::max(first, reading == Reading::grown ? leaf.lower : leaf.upper);
      else if (leaf.turn == Turn::leaves)
        last = std::min(last, reading == Reading::grown ? leaf.upper : leaf.lower);
      else if (reading == Reading::shrunk)
        return std::nullopt;
    }
    return first <= last ? std::optional(first) : std::nullopt;
  }

 private:
  const OpenLeaves& leaves_;
};

// The first s in [first, 1] in the expression as read; 2: there is none.
template <Reading reading>
double first_position(const SievedExpression& sieved, double first) {
  const CellsAsRead<reading> cells(sieved.leaves);
  return FirstPlace(cells).of(sieved.nodes.data(), first, 1).value_or(2);
}

// What is left of an expression for lower <= s <= upper: its value, or how many leaves stand.
struct Window {
  Truth truth = Truth::no;
  unsigned open_leaves = 0;
  const OpenLeaf* one_of_them = nullptr;
};

class WindowView {
 public:
  using Value = Window;

  WindowView(const OpenLeaves& leaves, double lower, double upper)
      : leaves_(leaves), lower_(lower), upper_(upper) {}

  static Window of_none(Operator op) { return {op == Operator::union_of ? Truth::no : Truth::yes}; }
  Window of_leaf(std::size_t place) const {
    const OpenLeaf& leaf = leaves_[place];
    const Truth truth = truth_of(leaf);
    return truth == Truth::open ? Window{truth, 1, &leaf} : Window{truth};
  }
  static bool is_settled(Operator op, const Window& all) {
    return all.truth == (op == Operator::union_of ? Truth::yes : Truth::no);
  }
  static void join(Operator op, Window& all, const Window& one) {
    if (is_settled(op, one))
      all = one;
    else if (one.truth == Truth::open)
      all = {Truth::open, all.open_leaves + one.open_leaves, one.one_of_them};
  }

 private:
  Truth truth_of(const OpenLeaf& leaf) const {
    if (leaf.turn == Turn::undecided) return Truth::open;
    const bool is_before = leaf.upper < lower_, is_after = upper_ < leaf.lower;
    if (!is_before && !is_after) return Truth::open;
    return is_before == (leaf.turn == Turn::enters) ? Truth::yes : Truth::no;
  }

  const OpenLeaves& leaves_;
  const double lower_;
  const double upper_;
};

Window window(const SievedExpression& sieved, double lower, double upper) {
  return evaluate(WindowView(sieved.leaves, lower, upper), sieved.nodes.data());
}

}  // namespace

void sieve(const Expression& expression, const Node* node, const Probe& probe, SievedExpression& sieved) {
  sieved.nodes.clear();
  sieved.leaves.clear();
  LeavesOfRange leaves(expression, probe, sieved.leaves);
  const Truth truth = Simplifier(leaves, sieved.nodes).add(node);
  if (truth != Truth::open)
    sieved.nodes.push_back({.kind = truth == Truth::yes ? NodeKind::everything : NodeKind::nothing});
}

Meeting meet(const SievedExpression& sieved) {
  const double lower = first_position<Reading::grown>(sieved, 0);
  if (lower > 1) return no_meeting;
  if (lower == 0 && window(sieved, 0, 0).truth == Truth::yes) return {0, -1};
  return {lower, first_position<Reading::shrunk>(sieved, lower)};
}

Leaf sole_leaf(const SievedExpression& sieved, const Meeting& meeting) {
  if (!(meeting.lower > 0)) return no_leaf;
  const Window left = window(sieved, meeting.lower, meeting.upper);
  const bool is_sole =
      left.truth == Truth::open && left.open_leaves == 1 && left.one_of_them->turn == Turn::enters;
  return is_sole ? left.one_of_them->leaf : no_leaf;
}

}  // namespace groundtruth::fast
