#include <groundtruth/diagnosis/groups.hpp>

#include <algorithm>
#include <map>

#include <groundtruth/diagnosis/irrelevance.hpp>

namespace groundtruth::diagnosis {
namespace {

struct Skeleton {
  std::string operator()(const Shape& shape) const { return std::visit(*this, shape.expression); }
  std::string operator()(const Everything&) const { return "everything"; }
  std::string operator()(const Nothing&) const { return "nothing"; }
  std::string operator()(const HalfSpace&) const { return "halfspace"; }
  std::string operator()(const Union& shape) const { return "union" + listed(shape.operands); }
  std::string operator()(const Intersection& shape) const { return "intersection" + listed(shape.operands); }
  std::string operator()(const Covered& cover) const { return "material(" + (*this)(*cover.over) + ")"; }
  std::string operator()(const Painted& paint) const {
    return "paint(" + (*this)(*paint.where) + " over " + (*this)(*paint.over) + ")";
  }

 private:
  std::string listed(const std::vector<Shape>& operands) const {
    std::string text;
    for (const Shape& operand : operands) text += (text.empty() ? "(" : " ") + (*this)(operand);
    return text.empty() ? "()" : text + ")";
  }
};

std::string kind_of(const Ask& ask) {
  if (std::holds_alternative<EntryAsk>(ask)) return "entry";
  if (std::holds_alternative<ClipAsk>(ask)) return "clip";
  const WheelState& state = std::get<StepAsk>(ask).state;
  const auto* contact = std::get_if<Contact>(&state);
  if (contact == nullptr) return "step from free";
  return contact->grip == Grip::stick ? "step from stick" : "step from slip";
}

class Gatherer {
 public:
  Gatherer(std::span<const Failure> failures, const std::function<StillFail(const Failure&)>& still_fail,
           const GroupBudget& budget)
      : failures_(failures), still_fail_(still_fail), budget_(budget) {}

  std::vector<Group> run() {
    std::map<std::string, std::vector<std::size_t>> by_kind;
    for (std::size_t i = 0; i < failures_.size(); ++i)
      by_kind[kind_of(failures_[i].failing.ask) + " " + failures_[i].kind].push_back(i);
    // In turns, so that each kind gets its share of the budget.
    for (std::size_t turn = 0; has_turn(by_kind, turn); ++turn)
      for (const auto& [kind, members] : by_kind)
        if (turn < members.size()) take(members, turn);
    std::stable_sort(groups_.begin(), groups_.end(),
                     [](const Group& a, const Group& b) { return a.members.size() > b.members.size(); });
    return std::move(groups_);
  }

 private:
  static constexpr std::size_t most_turns = 4;

  bool has_turn(const std::map<std::string, std::vector<std::size_t>>& by_kind, std::size_t turn) const {
    return std::any_of(by_kind.begin(), by_kind.end(),
                       [&](const auto& kind) { return turn < kind.second.size(); });
  }

  void take(const std::vector<std::size_t>& members, std::size_t turn) {
    const std::size_t place = members[turn];
    if (turn < most_turns && shrunk_ < 2 * budget_.most_groups) {
      add(place);
      return;
    }
    const auto home = std::find_if(groups_.begin(), groups_.end(), [&](const Group& group) {
      return std::find(members.begin(), members.end(), group.members.front()) != members.end();
    });
    if (home != groups_.end()) home->members.push_back(place);
  }

  void add(std::size_t place) {
    const Failure& failure = failures_[place];
    const StillFail still_fail = still_fail_(failure);
    Shrunk shrunk = shrink(failure.failing, still_fail, budget_.of_one);
    ++shrunk_;
    const std::string signature = signature_of(shrunk.smallest);
    const auto known = std::find_if(groups_.begin(), groups_.end(), [&](const Group& group) {
      return group.kind == failure.kind && group.signature == signature;
    });
    if (known != groups_.end()) {
      known->members.push_back(place);
      return;
    }
    if (groups_.size() == budget_.most_groups) return;
    auto does_not_matter = inputs_that_do_not_matter(shrunk.smallest, still_fail);
    groups_.push_back({failure.kind, signature, std::move(shrunk), std::move(does_not_matter), {place}});
  }

  std::span<const Failure> failures_;
  const std::function<StillFail(const Failure&)>& still_fail_;
  const GroupBudget budget_;
  std::size_t shrunk_ = 0;
  std::vector<Group> groups_;
};

}  // namespace

std::string signature_of(const cases::Case& with) {
  const std::string kind = kind_of(with.ask);
  return kind == "clip" ? kind : kind + " " + Skeleton{}(with.scene.shape);
}

std::vector<Group> gather(std::span<const Failure> failures,
                          const std::function<StillFail(const Failure&)>& still_fail,
                          const GroupBudget& budget) {
  return Gatherer(failures, still_fail, budget).run();
}

}  // namespace groundtruth::diagnosis
