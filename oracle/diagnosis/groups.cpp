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
        if (turn < members.size()) take(kind, members[turn], turn);
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

  void take(const std::string& kind, std::size_t place, std::size_t turn) {
    const auto home = first_of_kind_.find(kind);
    const bool is_home_enough = turn >= most_turns || shrunk_ >= 2 * budget_.most_groups;
    if (home != first_of_kind_.end() && is_home_enough)
      groups_[home->second].members.push_back(place);
    else
      first_of_kind_.emplace(kind, add(kind, place));
  }

  // The group that the failure joins, perhaps a new one.
  std::size_t add(const std::string& kind, std::size_t place) {
    const Failure& failure = failures_[place];
    const StillFail still_fail = still_fail_(failure);
    Shrunk shrunk = shrink(failure.failing, still_fail, budget_.of_one);
    ++shrunk_;
    const std::string signature = signature_of(shrunk.smallest);
    auto group = std::find_if(groups_.begin(), groups_.end(), [&](const Group& known) {
      return known.kind == failure.kind && known.signature == signature;
    });
    const auto home = first_of_kind_.find(kind);
    const bool is_full = groups_.size() >= budget_.most_groups && home != first_of_kind_.end();
    if (group == groups_.end() && is_full)
      group = groups_.begin() + static_cast<std::ptrdiff_t>(home->second);
    if (group == groups_.end()) {
      auto does_not_matter = inputs_that_do_not_matter(shrunk.smallest, still_fail);
      groups_.push_back({failure.kind, signature, std::move(shrunk), std::move(does_not_matter), {}});
      group = std::prev(groups_.end());
    }
    group->members.push_back(place);
    return static_cast<std::size_t>(group - groups_.begin());
  }

  std::span<const Failure> failures_;
  const std::function<StillFail(const Failure&)>& still_fail_;
  const GroupBudget budget_;
  std::size_t shrunk_ = 0;
  std::vector<Group> groups_;
  std::map<std::string, std::size_t> first_of_kind_;  // places in groups_
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
