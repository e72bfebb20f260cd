#include <cstdlib>
#include <new>

#include <gtest/gtest.h>
#include <groundtruth/fast/clip.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/fast/follower.hpp>
#include <groundtruth/fast/step.hpp>
#include <groundtruth/tests/fast/shapes.hpp>

namespace {
thread_local volatile std::size_t allocations = 0;  // volatile: compilers think they know what new does
}

// Not inlined: compilers would see that new's partner is free, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocations = allocations + 1;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace groundtruth {
namespace {

fast::Scene runway() {
  std::vector<Shape> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back(box({1.0 * i, 0, -1}, {i + 1.0, 1, 0}));
  const Friction rubber{0.5, 0.25};
  return fast::compile(Scene{{{"dry", {{"rubber", rubber}}, std::nullopt}},
                             cover(0, paint(0, box({3, 0, 0}, {5, 1, 0}), unite(boxes)))});
}

template <class Ask>
std::size_t allocations_of(Ask ask) {
  const std::size_t before = allocations;
  [[maybe_unused]] const auto answer = ask();
  return allocations - before;
}

TEST(FastAsks, AllocateNothing) {
  const fast::Scene scene = runway();
  const EntryAsk plain{{3.5, 0.5, 1}, {3.5, 0.5, -1}}, corner{{4, 1, 1}, {4, 1, -1}};
  const EntryAsk in_seam{{4, 0.5, -0.5}, {4, 0.5, -1}}, along_the_top{{0, 0.5, 0}, {99, 0.5, 0}};
  for (const EntryAsk& ask : {plain, corner, in_seam, along_the_top})
    EXPECT_EQ(allocations_of([&] { return fast::entry_point(scene, ask); }), 0u);

  EXPECT_EQ(allocations_of([] { return fast::clip({{3, 4, 5}, {0, 0, -1}, 0.1, 0.1}); }), 0u);

  StepAsk step;
  step.wheel = {.k_xy = -1,
                .k_z = -1,
                .d_xy = 0,
                .d_z = 0,
                .z_min = 0.25,
                .z_zero = 0.75,
                .z_max = 0.75,
                .tyre = "rubber"};
  step.frame.position_in_world = {3.5, 0.5, 0.5};
  step.frame.world_from_wheel = {0, 1, 0, 0};
  step.h = 1;
  EXPECT_EQ(allocations_of([&] { return fast::step(scene, step); }), 0u);
  step.state = Contact{Grip::slip, {4, 0.5, 0}, {}, {0, 0, 1}, 0.5, 0.25, std::nullopt};
  EXPECT_EQ(allocations_of([&] { return fast::step(scene, step); }), 0u);
}

TEST(FastAsks, AllocateNothingWhereAFollowerKnowsTheSurroundings) {
  const fast::Scene scene = runway();
  fast::Follower follower(scene);
  const auto ask = [](int i) { return EntryAsk{{1 + 0.01 * i, 0.5, 1}, {1 + 0.01 * i, 0.5, -1}}; };
  for (int i = 0; i < 3; ++i) follower.entry_point(ask(i));
  for (int i = 3; i < 40; ++i)
    EXPECT_EQ(allocations_of([&] { return follower.entry_point(ask(i)); }), 0u) << i;
}

TEST(FastAsks, AreSeenWhenTheyDoAllocate) {
  const auto allocate = [] {
    static void* volatile memory;  // volatile: an allocation that nobody sees may be left out
    memory = ::operator new(1);
    ::operator delete(memory);
    return 0;
  };
  EXPECT_EQ(allocations_of(allocate), 1u);
}

}  // namespace
}  // namespace groundtruth
