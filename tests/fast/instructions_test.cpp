// The kernels for this processor and the portable ones give the same bits.

#include <bit>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/scene_builders.hpp>
#include <groundtruth/fast/cell_kernels.hpp>
#include <groundtruth/fast/entry_point.hpp>

namespace groundtruth::fast {
namespace {

constexpr std::uint64_t asks_per_scene = 20000;

// Like ==, but -0 differs from 0.
bool have_same_bits(const EntryAnswer& a, const EntryAnswer& b) {
  if (!(a == b)) return false;
  const auto lambda_bits = [](const EntryAnswer& answer) {
    if (const auto* border = std::get_if<Border>(&answer))
      return std::bit_cast<std::uint64_t>(border->lambda);
    if (const auto* inside = std::get_if<Inside>(&answer))
      return std::bit_cast<std::uint64_t>(inside->lambda);
    return std::uint64_t{0};
  };
  return lambda_bits(a) == lambda_bits(b);
}

std::vector<groundtruth::Scene> scenes() {
  return {cases::house(), cases::runway_of(100), cases::town_of(300, 5), cases::hills_of(12),
          cases::random_nested(3, 6, 4)};
}

TEST(Instructions, AnswersAreTheSameBitsWithAnyInstructions) {
  const CompileOptions portable = CompileOptions{}.answer_with(Instructions::portable);
  for (const groundtruth::Scene& scene : scenes()) {
    const Scene by_best = compile(scene), by_portable = compile(scene, portable);
    const cases::AskSource source(scene, 11, {1, 0, 0});
    for (std::uint64_t i = 0; i < asks_per_scene; ++i) {
      const EntryAsk ask = std::get<EntryAsk>(source.ask_at(i).ask);
      ASSERT_TRUE(have_same_bits(entry_point(by_best, ask), entry_point(by_portable, ask))) << "ask " << i;
    }
  }
}

TEST(Instructions, PortableKernelsCanBeForced) {
  const CompileOptions portable = CompileOptions{}.answer_with(Instructions::portable);
  EXPECT_EQ(compile(cases::house(), portable).parts().kernels, &portable_cell_kernels);
  EXPECT_EQ(compile(cases::house()).parts().kernels, &best_cell_kernels());
}

TEST(Instructions, BothKernelsLeaveTheSameOfBoxes) {
  const Scene scene = compile(cases::town_of(300, 5));
  const BoxWay way{{0.5F, 3, 9}, {0.25F, 2, 10}, {0.01F, 0.02F, -0.1F}, {true, true, false}};
  for (const BoxNode& node : scene.parts().hierarchy.nodes) {
    float by_best[BoxNode::width], by_portable[BoxNode::width];
    EXPECT_EQ(best_cell_kernels().meet_boxes(node, way, 1, by_best),
              portable_cell_kernels.meet_boxes(node, way, 1, by_portable));
    EXPECT_EQ(std::memcmp(by_best, by_portable, sizeof by_best), 0);
  }
}

}  // namespace
}  // namespace groundtruth::fast
