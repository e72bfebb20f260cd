#pragma once
// What the tests of a tolerance in metres share: built-in scenes, their asks, and shapes with moved planes.

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>

#include "judging.hpp"

namespace groundtruth::judge {

// Less than the thinnest part of a scene, and more.
inline double tau_number(std::size_t index) { return std::array{0.001, 0.01, 0.1, 0.5}[index % 4]; }

inline double length_of(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

// The shape with each offset changed by what `change` makes of its half-space.
template <typename Change>
Shape with_offsets(const Shape& shape, Change& change) {
  Shape result = shape;
  const auto all = [&](std::vector<Shape>& operands) {
    for (Shape& operand : operands) operand = with_offsets(operand, change);
  };
  if (auto* leaf = std::get_if<HalfSpace>(&result.expression)) leaf->offset += change(*leaf);
  if (auto* of = std::get_if<Union>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Intersection>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Covered>(&result.expression))
    of->over = std::make_shared<const Shape>(with_offsets(*of->over, change));
  if (auto* of = std::get_if<Painted>(&result.expression))
    of->over = std::make_shared<const Shape>(with_offsets(*of->over, change));
  return result;
}

inline const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> built;
    for (const char* name : {"house", "ramp", "degenerate", "nested"}) {
      const auto pack = cases::find_builtin_scene(name)->build();
      for (std::size_t part = 0; part < pack.size(); part += 3) built.push_back(pack[part]);
    }
    return built;
  }();
  return all;
}

inline const Scene& scene_number(std::size_t index) { return scenes()[index % scenes().size()]; }

inline EntryAsk entry_ask(const Scene& scene, std::uint64_t seed, std::uint64_t index) {
  return std::get<EntryAsk>(cases::AskSource(scene, seed, {1, 0, 0}).ask_at(index).ask);
}

}  // namespace groundtruth::judge
