#include <groundtruth/campaign/campaign.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>

#include <groundtruth/cases/random.hpp>
#include <groundtruth/cases/shape_parts.hpp>

namespace groundtruth::campaign {
namespace {

using implementations::Answered;
using implementations::EngineOnScene;
using Clock = std::chrono::steady_clock;

// A run of consecutive asks of one scene: what a thread takes at a time.
struct Batch {
  std::size_t part = 0;
  std::uint64_t first = 0;
  std::uint64_t end = 0;
};

std::vector<Batch> batches_of(const Plan& plan) {
  constexpr std::uint64_t batch_size = 64;
  std::vector<Batch> batches;
  const std::uint64_t parts = plan.pack.size();
  for (std::size_t part = 0; part < parts; ++part) {
    const std::uint64_t asks = plan.asks / parts + (part < plan.asks % parts ? 1 : 0);
    for (std::uint64_t first = 0; first < asks; first += batch_size) {
      batches.push_back({part, first, std::min(first + batch_size, asks)});
    }
  }
  return batches;
}

Sampling sampling_of(const std::string& engine, std::size_t leaves) {
  if (engine == "definition") return definition_sampling(leaves);
  if (engine == "proved") return proved_sampling(leaves);
  return {};
}

struct EngineOnPart {
  std::unique_ptr<const EngineOnScene> engine;
  Sampling sampling;

  std::uint64_t one_in(const Ask& ask) const {
    return std::array{sampling.entry, sampling.clip, sampling.step}[ask.index()];
  }
};

struct Part {
  cases::AskSource source;
  std::vector<EngineOnPart> engines;
};

std::vector<Part> prepare(const Plan& plan) {
  std::vector<std::unique_ptr<const implementations::Engine>> engines;
  for (const std::string& name : plan.engines) engines.push_back(implementations::make_engine(name));
  std::vector<Part> parts;
  for (std::size_t i = 0; i < plan.pack.size(); ++i) {
    const Scene& scene = plan.pack[i];
    Part part{asks_for(plan, i), {}};
    for (const auto& engine : engines) {
      part.engines.push_back(
          {engine->on(scene), sampling_of(engine->name(), cases::leaf_count(scene.shape))});
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

class Worker {
 public:
  Worker(const std::vector<Part>& parts, std::size_t engines) : parts_(parts), tallies_(engines) {}

  void answer(const Batch& batch) {
    const Part& part = parts_[batch.part];
    asks_.clear();
    for (std::uint64_t i = batch.first; i < batch.end; ++i) asks_.push_back(part.source.ask_at(i).ask);
    exact_.resize(asks_.size());
    for (std::size_t engine = 0; engine < tallies_.size(); ++engine)
      answer(batch, part.engines[engine], engine);
  }

  const std::vector<Tally>& tallies() const { return tallies_; }

 private:
  void answer(const Batch& batch, const EngineOnPart& engine, std::size_t engine_index) {
    std::vector<std::size_t> asked;
    Tally& tally = tallies_[engine_index];
    for (std::size_t i = 0; i < asks_.size(); ++i) {
      const std::uint64_t one_in = engine.one_in(asks_[i]);
      if (one_in == 0) continue;
      if ((batch.first + i) % one_in == 0) {
        asked.push_back(i);
      } else {
        tally.leave_out();
      }
    }
    std::vector<Answered> answers(asked.size());
    const auto start = Clock::now();
    for (std::size_t k = 0; k < asked.size(); ++k) answers[k] = engine.engine->answer(asks_[asked[k]]);
    tally.add_time(std::chrono::duration<double>(Clock::now() - start).count());
    if (engine_index == 0) exact_ = answers;
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const Answered& truth = exact_[asked[k]];
      tally.add(judge::compare({answers[k].answer, answers[k].evidence}, {truth.answer, truth.evidence}),
                {batch.part, batch.first + asked[k]});
    }
  }

  const std::vector<Part>& parts_;
  std::vector<Tally> tallies_;
  std::vector<Ask> asks_;
  std::vector<Answered> exact_;
};

}  // namespace

Sampling definition_sampling(std::size_t leaves) {
  const std::uint64_t large = leaves / 256;
  return {1 + large * 4, 2, 8 + large};
}

Sampling proved_sampling(std::size_t leaves) { return {1 + leaves / 1024, 0, 0}; }

cases::AskSource asks_for(const Plan& plan, std::size_t part) {
  return {plan.pack[part], cases::seed_of_part(plan.seed, part)};
}

std::vector<Tally> run(const Plan& plan, const std::function<void(std::uint64_t)>& progress) {
  const std::vector<Part> parts = prepare(plan);
  const std::vector<Batch> batches = batches_of(plan);
  std::vector<Worker> workers(plan.jobs, Worker(parts, plan.engines.size()));
  std::atomic<std::size_t> next = 0;
  std::mutex progress_mutex;
  std::uint64_t done = 0;
  const auto work = [&](Worker& worker) {
    for (std::size_t i = next++; i < batches.size(); i = next++) {
      worker.answer(batches[i]);
      const std::lock_guard lock(progress_mutex);
      done += batches[i].end - batches[i].first;
      progress(done);
    }
  };
  std::vector<std::future<void>> working;
  for (Worker& worker : workers) working.push_back(std::async(std::launch::async, work, std::ref(worker)));
  for (std::future<void>& finished : working) finished.get();
  std::vector<Tally> tallies = workers.front().tallies();
  for (std::size_t i = 1; i < workers.size(); ++i) {
    for (std::size_t engine = 0; engine < tallies.size(); ++engine) {
      tallies[engine].merge(workers[i].tallies()[engine]);
    }
  }
  return tallies;
}

}  // namespace groundtruth::campaign
