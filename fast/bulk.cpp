// Many entry asks at a time.

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <type_traits>

#include <groundtruth/fast/decided_entry.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/fetch_ahead.hpp>
#include <groundtruth/fast/nearby_order.hpp>

namespace groundtruth::fast {

namespace {

// A thread that is to be started has to be worth it.
constexpr std::size_t fewest_asks_per_thread = 2048;
// Blocks large enough that neighbours find together, small enough that what is noted of them is cached.
constexpr std::size_t most_asks_per_block = 65536;
constexpr std::size_t blocks_per_thread = 4;  // so that none is waited for long

// To assign to an answer is to ask first what it was, and to wait for the memory that says so.
void answer_anew(const Scene& scene, const EntryAsk& ask, EntryAnswer& answer) {
  static_assert(std::is_trivially_destructible_v<EntryAnswer>);
  decide_entry(scene, ask, *std::construct_at(&answer));
}

void answer_block(const Scene& scene, NearbyOrder& nearby, std::span<const EntryAsk> asks,
                  std::span<EntryAnswer> answers) {
  const auto order = nearby.of(asks);
  if (order.empty()) {
    for (std::size_t i = 0; i != asks.size(); ++i) answer_anew(scene, asks[i], answers[i]);
    return;
  }
  FetchAhead ahead(scene, asks, answers, order);
  for (std::size_t i = 0; i != order.size(); ++i) {
    ahead.advance(i);
    answer_anew(scene, asks[order[i]], answers[order[i]]);
  }
}

// What the threads share: each takes the next block as long as there is one.
class Work {
 public:
  Work(const Scene& scene, std::span<const EntryAsk> asks, std::span<EntryAnswer> answers, std::size_t block)
      : scene_(scene), asks_(asks), answers_(answers), block_(block) {}

  void take_part() noexcept {
    try {
      NearbyOrder nearby(scene_);
      for (std::size_t first; (first = next_.fetch_add(block_)) < asks_.size();) {
        const std::size_t count = std::min(block_, asks_.size() - first);
        answer_block(scene_, nearby, asks_.subspan(first, count), answers_.subspan(first, count));
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }
  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const Scene& scene_;
  const std::span<const EntryAsk> asks_;
  const std::span<EntryAnswer> answers_;
  const std::size_t block_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void entry_points(const Scene& scene, std::span<const EntryAsk> asks, std::span<EntryAnswer> answers,
                  Threads threads) {
  const std::size_t useful = asks.size() / fewest_asks_per_thread;
  const std::size_t thread_count = std::clamp<std::size_t>(useful, 1, std::max(1U, threads.count));
  const std::size_t blocks = thread_count == 1 ? 1 : thread_count * blocks_per_thread;
  const std::size_t block = std::min(most_asks_per_block, asks.size() / blocks + 1);
  Work work(scene, asks, answers, block);
  {
    std::vector<std::jthread> others;
    others.reserve(thread_count - 1);
    try {
      while (others.size() + 1 < thread_count) others.emplace_back([&] { work.take_part(); });
    } catch (const std::system_error&) {
      // Fewer threads do the same work.
    }
    work.take_part();
  }
  work.rethrow_failure();
}

}  // namespace groundtruth::fast
