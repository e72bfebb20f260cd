#include <groundtruth/fast/sieved.hpp>

#include <cmath>
#include <optional>

namespace groundtruth::fast {

namespace {

enum class Truth : std::uint8_t { no, open, yes };

class Siever {
 public:
  Siever(const Expression& expression, const Probe& probe, SievedExpression& sieved)
      : expression_(expression), probe_(probe), sieved_(sieved) {}

  Truth add(const Node* node) {
    switch (node->kind) {
      case NodeKind::nothing:
        return Truth::no;
      case NodeKind::everything:
        return Truth::yes;
      case NodeKind::cell:
        return add_cell(*node);
      case NodeKind::union_of:
      case NodeKind::intersection_of:
        break;
    }
    return add_operator(node);
  }

 private:
  Truth add_operator(const Node* node) {
    const Truth absorbing = node->kind == NodeKind::union_of ? Truth::yes : Truth::no;
    const std::size_t place = sieved_.nodes.size(), leaves_before = sieved_.leaves.size();
    sieved_.nodes.push_back({.kind = node->kind});
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      if (add(operand) != absorbing) continue;
      sieved_.nodes.resize(place);
      sieved_.leaves.resize(leaves_before);
      return absorbing;
    }
    const std::size_t below = sieved_.nodes.size() - place - 1;
    if (below == 0) {
      sieved_.nodes.resize(place);
      return absorbing == Truth::yes ? Truth::no : Truth::yes;
    }
    sieved_.nodes[place].size = static_cast<std::uint32_t>(below + 1);
    return Truth::open;
  }

  Truth add_cell(const Node& node) {
    const auto first = static_cast<std::uint32_t>(sieved_.leaves.size());
    for (std::uint32_t leaf = node.first_leaf; leaf != node.end_leaf; ++leaf) {
      if (add_leaf(leaf) != Truth::no) continue;
      sieved_.leaves.resize(first);
      return Truth::no;
    }
    const auto end = static_cast<std::uint32_t>(sieved_.leaves.size());
    if (end == first) return Truth::yes;
    sieved_.nodes.push_back({NodeKind::cell, 1, first, end});
    return Truth::open;
  }

  // Lemma clip-interval, as in cell.cpp.
  Truth add_leaf(std::uint32_t leaf) {
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
    sieved_.leaves.push_back(open);
    return Truth::open;
  }

  const Expression& expression_;
  const Probe& probe_;
  SievedExpression& sieved_;
};

enum class Reading { grown, shrunk };

// The first s in [0, 1] in the expression with every error to its advantage, or against it.
template <Reading reading>
class FirstPosition {
 public:
  explicit FirstPosition(const SievedExpression& sieved) : sieved_(sieved) {}

  // No lower than `first`; 2 if there is none. Each round goes to a crossing further on.
  double from(double first) const {
    for (;;) {
      const double next = earliest(sieved_.nodes.data(), first, 1);
      if (!(next > first) || next > 1) return next;
      first = next;
    }
  }

 private:
  // A lower bound of the first position in [first, last], `first` iff that lies in the node; 2: none does.
  double earliest(const Node* node, double first, double last) const {
    switch (node->kind) {
      case NodeKind::nothing:
        return 2;
      case NodeKind::everything:
        return first;
      case NodeKind::cell:
        return earliest_in_cell(*node, first, last);
      case NodeKind::union_of:
        return earliest_in_union(node, first, last);
      case NodeKind::intersection_of:
        break;
    }
    double latest = first;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const double next = earliest(operand, first, last);
      if (next > 1) return 2;
      latest = std::max(latest, next);
    }
    return latest;
  }

  double earliest_in_union(const Node* node, double first, double last) const {
    double best = 2;
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const double next = earliest(operand, first, last);
      if (next > last) continue;
      if (!(next > first)) return first;
      best = last = next;
    }
    return best;
  }

  double earliest_in_cell(const Node& cell, double first, double last) const {
    for (std::uint32_t place = cell.first_leaf; place != cell.end_leaf; ++place) {
      const OpenLeaf& leaf = sieved_.leaves[place];
      if (leaf.turn == Turn::enters)
        first = std::max(first, reading == Reading::grown ? leaf.lower : leaf.upper);
      else if (leaf.turn == Turn::leaves)
        last = std::min(last, reading == Reading::grown ? leaf.upper : leaf.lower);
      else if (reading == Reading::shrunk)
        return 2;
    }
    return first <= last ? first : 2;
  }

  const SievedExpression& sieved_;
};

// What is left of an expression for lower <= s <= upper: its value, or how many leaves stand.
struct Window {
  Truth truth = Truth::no;
  unsigned open_leaves = 0;
  const OpenLeaf* one_of_them = nullptr;
};

class WindowView {
 public:
  WindowView(const SievedExpression& sieved, double lower, double upper)
      : sieved_(sieved), lower_(lower), upper_(upper) {}

  Window whole() const { return of(sieved_.nodes.data()); }

 private:
  Window of(const Node* node) const {
    switch (node->kind) {
      case NodeKind::nothing:
        return {Truth::no};
      case NodeKind::everything:
        return {Truth::yes};
      case NodeKind::cell:
        return of_cell(*node);
      case NodeKind::union_of:
      case NodeKind::intersection_of:
        break;
    }
    const Truth absorbing = node->kind == NodeKind::union_of ? Truth::yes : Truth::no;
    Window all{absorbing == Truth::yes ? Truth::no : Truth::yes};
    for (const Node* operand = node + 1; operand != node + node->size; operand += operand->size) {
      const Window one = of(operand);
      if (one.truth == absorbing) return one;
      if (one.truth == Truth::open) join(all, one);
    }
    return all;
  }

  Window of_cell(const Node& cell) const {
    Window all{Truth::yes};
    for (std::uint32_t place = cell.first_leaf; place != cell.end_leaf; ++place) {
      const OpenLeaf& leaf = sieved_.leaves[place];
      const Truth truth = truth_of(leaf);
      if (truth == Truth::no) return {Truth::no};
      if (truth == Truth::open) join(all, {Truth::open, 1, &leaf});
    }
    return all;
  }

  static void join(Window& all, const Window& one) {
    all.truth = Truth::open;
    all.open_leaves += one.open_leaves;
    all.one_of_them = one.one_of_them;
  }

  Truth truth_of(const OpenLeaf& leaf) const {
    if (leaf.turn == Turn::undecided) return Truth::open;
    const bool is_before = leaf.upper<lower_, is_after = leaf.lower> upper_;
    if (!is_before && !is_after) return Truth::open;
    return is_before == (leaf.turn == Turn::enters) ? Truth::yes : Truth::no;
  }

  const SievedExpression& sieved_;
  const double lower_;
  const double upper_;
};

}  // namespace

void sieve(const Expression& expression, const Node* node, const Probe& probe, SievedExpression& sieved) {
  sieved.nodes.clear();
  sieved.leaves.clear();
  const Truth truth = Siever(expression, probe, sieved).add(node);
  if (truth != Truth::open)
    sieved.nodes.push_back({.kind = truth == Truth::yes ? NodeKind::everything : NodeKind::nothing});
}

Meeting meet(const SievedExpression& sieved) {
  const double lower = FirstPosition<Reading::grown>(sieved).from(0);
  if (lower > 1) return no_meeting;
  if (lower == 0 && WindowView(sieved, 0, 0).whole().truth == Truth::yes) return {0, -1};
  return {lower, FirstPosition<Reading::shrunk>(sieved).from(lower)};
}

Leaf sole_leaf(const SievedExpression& sieved, const Meeting& meeting) {
  if (!(meeting.lower > 0)) return no_leaf;
  const Window window = WindowView(sieved, meeting.lower, meeting.upper).whole();
  const bool is_sole =
      window.truth == Truth::open && window.open_leaves == 1 && window.one_of_them->turn == Turn::enters;
  return is_sole ? window.one_of_them->leaf : no_leaf;
}

}  // namespace groundtruth::fast
