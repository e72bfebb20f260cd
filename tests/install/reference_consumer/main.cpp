// A user of the installed libraries: reads a scene, asks the exact engine and the fast one.
#include <cstdio>

#include <groundtruth/exact/entry_point.hpp>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/text/scene_text.hpp>

int main() {
  const groundtruth::Scene scene = groundtruth::read_scene(
      R"({"groundtruth": "scene/1", "shape": {"box": [[0, 0, 0], [1, 1, 1]]}})", {"inline", 1});
  const groundtruth::EntryAsk ask{{0.5, 0.5, 2}, {0.5, 0.5, -1}};

  const auto exact = groundtruth::exact::entry_point(groundtruth::exact::Scene(scene), ask);
  const auto fast = groundtruth::fast::entry_point(groundtruth::fast::compile(scene), ask);
  std::printf("exact %s, fast %a\n", exact.evidence.lambda_exact.c_str(),
              std::get<groundtruth::Border>(fast).lambda);
}
