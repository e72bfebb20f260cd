#include <groundtruth/validation/strand.hpp>

#include <algorithm>
#include <deque>
#include <unordered_set>
#include <utility>

#include <groundtruth/cases/random.hpp>
#include <groundtruth/validation/circumstances.hpp>
#include <groundtruth/validation/making.hpp>

namespace groundtruth::validation {
namespace {

constexpr std::size_t fresh_batch = 12;
constexpr std::size_t brood = 8;
constexpr std::size_t most_parents = 64;
constexpr std::size_t most_changes = 8;

struct Parent {
  CaseName name;
  std::shared_ptr<const Scene> scene;
  Ask ask;
  Answer exact;
};

class Strand : public Stream {
 public:
  explicit Strand(const StrandPlan& plan)
      : plan_(plan), random_(cases::seed_of_part(~plan.seed, plan.number)) {}

  std::optional<Batch> next() override {
    if (given_ == plan_.cases || has_failed_enough()) return std::nullopt;
    const bool breeds = !parents_.empty() && random_.below(5) < 2;
    Batch batch = breeds ? offspring_of(random_.pick(parents_)) : fresh();
    const std::uint64_t left = plan_.cases - given_;
    if (batch.asks.size() > left) {
      batch.asks.resize(left);
      names_.resize(left);
    }
    for (const CaseName& name : names_) batch.ids.push_back(write_case_name(name));
    given_ += batch.asks.size();
    last_ = batch;
    return batch;
  }

  bool has_failed_enough() const override {
    return plan_.most_failures > 0 && failures_ >= plan_.most_failures && given_ < plan_.cases;
  }

  void learn(std::span<const Finding> findings) override {
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const Finding& finding = findings[i];
      failures_ += is_failure(finding.outcome);
      const bool is_new = seen_.insert(circumstances_of(last_.asks[i], finding)).second;
      if (!is_new || finding.outcome == Outcome::skipped || names_[i].changes.size() == most_changes)
        continue;
      Parent& parent = parents_.emplace_back();
      parent.name = names_[i];
      parent.scene = last_.scene;
      parent.ask = last_.asks[i];
      parent.exact = finding.verdict.exact;
      if (parents_.size() > most_parents) parents_.pop_front();
    }
  }

 private:
  Kind some_kind() {
    const Shares& shares = plan_.shares;
    const std::uint64_t drawn = random_.below(std::uint64_t{shares.entry} + shares.clip + shares.step);
    if (drawn < shares.entry) return Kind::entry;
    return drawn < std::uint64_t{shares.entry} + shares.clip ? Kind::clip : Kind::step;
  }

  Batch fresh() {
    const std::uint64_t number = fresh_batches_++;
    Batch batch{std::make_shared<const Scene>(scene_of_batch(plan_.seed, plan_.number, number)), {}, {}};
    const FreshAsks source(*batch.scene, plan_.seed, plan_.number, number);
    names_.clear();
    for (std::uint64_t i = 0; i < fresh_batch; ++i) {
      names_.push_back({plan_.seed, plan_.number, number, some_kind(), i, {}});
      batch.asks.push_back(source.ask_at(names_.back().kind, i));
    }
    return batch;
  }

  // Half of the broods live in their parent's scene, the others in one like it.
  Batch offspring_of(const Parent& parent) {
    constexpr std::uint64_t many = 1000000;
    const bool moves = kind_of_ask(parent.ask) != Kind::clip && random_.one_in(2);
    const auto of_scene = static_cast<std::uint32_t>(moves ? 1 + random_.below(many) : 0);
    Batch batch{parent.scene, {}, {}};
    if (moves) batch.scene = std::make_shared<const Scene>(changed_scene(*parent.scene, {of_scene, 0}));
    names_.clear();
    for (std::size_t i = 0; i < brood; ++i) {
      const bool same_ask = moves && i == 0;
      const Change change{of_scene, static_cast<std::uint32_t>(same_ask ? 0 : 1 + random_.below(many))};
      names_.push_back(parent.name);
      names_.back().changes.push_back(change);
      batch.asks.push_back(changed_ask(parent.ask, parent.exact, change));
    }
    return batch;
  }

  StrandPlan plan_;
  cases::Random random_;
  std::uint64_t given_ = 0;
  std::uint64_t failures_ = 0;
  std::uint64_t fresh_batches_ = 0;
  std::vector<CaseName> names_;  // of the last batch
  Batch last_;
  std::deque<Parent> parents_;
  std::unordered_set<std::uint64_t> seen_;
};

}  // namespace

std::unique_ptr<Stream> strand_of(const StrandPlan& plan) { return std::make_unique<Strand>(plan); }

}  // namespace groundtruth::validation
