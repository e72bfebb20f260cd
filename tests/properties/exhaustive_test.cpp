// Every case of a small domain. Half-spaces: normals in {-1, 0, 1}^3, the zero normal included, offsets in
// {-1, 0, 1}:
// 81. Segments: all 729 from a point of the lattice {-1, 0, 1}^3 to another or the same, range [0, 1].
// Scenes are taken up to the cube's 48 symmetries: one whose numbers come first in lexicographic order stands
// for all, as the segments are symmetric too (that symmetry itself is a law of entry_motions_test.cpp).
// Complete: all shapes of one leaf; all unions and all intersections of two. Of three leaves (union,
// intersection, a n (b u c), a u (b n c), each of the 81^3 triples), every 101st triple, and of its segments
// every 27th, the first moving on from triple to triple, so that all segments have their turn.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include <groundtruth/tests/properties/literal_faces.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

constexpr int half_space_count = 81;

Vector lattice_point(int index) {
  return {static_cast<double>(index / 9 % 3 - 1), static_cast<double>(index / 3 % 3 - 1),
          static_cast<double>(index % 3 - 1)};
}

int index_of(const Vector& lattice_point) {
  return static_cast<int>((lattice_point[0] + 1) * 9 + (lattice_point[1] + 1) * 3 + lattice_point[2] + 1);
}

HalfSpace half_space_at(int index) { return {lattice_point(index / 3), static_cast<double>(index % 3 - 1)}; }

// What each symmetry of the cube makes of each half-space.
const std::vector<std::array<int, half_space_count>>& symmetries() {
  static const auto all = [] {
    std::vector<std::array<int, half_space_count>> images;
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
      for (int signs = 0; signs < 8; ++signs) {
        std::array<int, half_space_count> image{};
        for (int i = 0; i < half_space_count; ++i) {
          const HalfSpace h = half_space_at(i);
          Vector normal{};
          for (std::size_t axis = 0; axis < 3; ++axis)
            normal[axis] = (signs >> axis & 1 ? -1 : 1) * h.normal[axes[axis]];
          image[static_cast<std::size_t>(i)] = index_of(normal) * 3 + i % 3;
        }
        images.push_back(image);
      }
    } while (std::next_permutation(axes.begin(), axes.end()));
    return images;
  }();
  return all;
}

// Whether no symmetry, with the leaves in ascending order again, comes before these leaves.
bool stands_for_all(const std::vector<int>& leaves) {
  return std::all_of(symmetries().begin(), symmetries().end(), [&](const auto& image) {
    std::vector<int> other;
    for (const int leaf : leaves) other.push_back(image[static_cast<std::size_t>(leaf)]);
    std::sort(other.begin(), other.end());
    return leaves <= other;
  });
}

Shape leaf(int index) { return {half_space_at(index)}; }

std::string failure(const Ground& ground, const EntryAsk& ask, const Entered& entered) {
  std::ostringstream out;
  out << "not what the rule says word by word: " << entered << "\n" << replay(ground.scene(), ask);
  return out.str();
}

// Every `stride`th segment from the `first`. Disagreement of the engines throws.
void ask_segments(const Shape& shape, int first, int stride) {
  const Ground ground(Scene{{}, shape});
  for (int segment = first; segment < 27 * 27; segment += stride) {
    const EntryAsk ask{lattice_point(segment / 27), lattice_point(segment % 27)};
    const Entered entered = ground.entry(ask);
    if (entered.is_miss()) continue;
    const LiteralFaces literal = literal_faces(shape, ask, *entered.lambda);
    const bool same = entered.is_inside() == literal.interior && entered.admissible == literal.admissible;
    ASSERT_TRUE(same) << failure(ground, ask, entered);
  }
}

TEST(Exhaustive, AllShapesOfOneLeafAgainstAllSegments) {
  for (int i = 0; i < half_space_count; ++i) ask_segments(leaf(i), 0, 1);
}

TEST(Exhaustive, AllShapesOfTwoLeavesUpToSymmetryAgainstAllSegments) {
  int shapes = 0;
  for (int i = 0; i < half_space_count; ++i) {
    for (int j = i; j < half_space_count; ++j) {
      if (!stands_for_all({i, j})) continue;
      ask_segments(any_of({leaf(i), leaf(j)}), 0, 1);
      ask_segments(all_of({leaf(i), leaf(j)}), 0, 1);
      shapes += 2;
    }
  }
  RecordProperty("shapes", shapes);
  EXPECT_GT(shapes, 2 * 6642 / 96);
}

TEST(Exhaustive, EveryFewShapesOfThreeLeavesAgainstEveryFewSegments) {
  constexpr int triples = half_space_count * half_space_count * half_space_count;
  int first = 0;
  for (int triple = 0; triple < triples; triple += 101) {
    const Shape a = leaf(triple / 6561), b = leaf(triple / 81 % 81), c = leaf(triple % 81);
    for (const Shape& shape :
         {any_of({a, b, c}), all_of({a, b, c}), all_of({a, any_of({b, c})}), any_of({a, all_of({b, c})})}) {
      ask_segments(shape, first, 27);
      first = (first + 1) % 27;
    }
  }
}

}  // namespace
}  // namespace groundtruth::properties
