#include <groundtruth/stability/shared_out.hpp>

#include <atomic>
#include <thread>
#include <vector>

namespace groundtruth::stability {

void share_out(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work,
               const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  std::atomic<std::size_t> next{0}, done{0};
  const auto take = [&](const std::function<void()>& after_each) {
    for (std::size_t i = next++; i < count; i = next++) {
      work(i);
      ++done;
      after_each();
    }
  };
  std::vector<std::jthread> helpers;
  for (unsigned i = 1; i < jobs; ++i) helpers.emplace_back([&] { take([] {}); });
  take([&] { progress(done, count); });
}

}  // namespace groundtruth::stability
