#pragma once
// The scenes and asks of every table here.

#include <functional>
#include <string>
#include <vector>

#include <groundtruth/problem/scene.hpp>
#include <groundtruth/tests/bench/asks.hpp>

namespace groundtruth::bench {

struct TimedScene {
  std::string name;
  std::function<Scene()> build;
  Extent extent;
};

struct AskKind {
  std::string name;
  std::vector<EntryAsk> (*make)(const Extent&, std::size_t);
};

const std::vector<TimedScene>& timed_scenes();
const std::vector<AskKind>& ask_kinds();

TimedScene town(const std::string& name, std::size_t houses);

}  // namespace groundtruth::bench
