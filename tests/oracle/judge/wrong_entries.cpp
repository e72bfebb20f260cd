#include <algorithm>
#include <cmath>
#include <limits>

#include <groundtruth/cases/shape_parts.hpp>

#include "wrong_kinds.hpp"

namespace groundtruth::judge {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double moved_by(double value, int doubles) {
  for (int i = 0; i < std::abs(doubles); ++i)
    value = std::nextafter(value, doubles > 0 ? infinity : -infinity);
  return value;
}

bool are_parallel(const Vector& a, const Vector& b) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return std::fabs(static_cast<long double>(a[i]) * b[j] - static_cast<long double>(a[j]) * b[i]);
  };
  const auto size = [](const Vector& v) {
    return std::hypot(static_cast<long double>(v[0]), static_cast<long double>(v[1]),
                      static_cast<long double>(v[2]));
  };
  return minor(0, 1) + minor(1, 2) + minor(2, 0) <= 1e-9L * size(a) * size(b);
}

// Leaf, normal and material, each of something else.
void add_wrong_faces(const Scene& scene, const Border& border, const std::vector<Leaf>& admissible,
                     std::vector<WrongAnswer>& wrong) {
  const auto add = [&](const char* change, const auto& edit) {
    Border other = border;
    edit(other);
    wrong.push_back({change, EntryAnswer{other}});
  };
  const std::vector<HalfSpace> leaves = leaves_in_order(scene.shape);
  for (Leaf leaf = 0; leaf < leaves.size(); ++leaf) {
    if (std::find(admissible.begin(), admissible.end(), leaf) == admissible.end()) {
      add("a leaf that is not admissible", [&](Border& b) {
        b.leaf = leaf;
        b.normal_in_world = leaves[leaf].normal;
      });
      add("the number of a leaf that is not admissible", [&](Border& b) { b.leaf = leaf; });
    }
    if (!are_parallel(leaves[leaf].normal, border.normal_in_world))
      add("the normal of another leaf", [&](Border& b) { b.normal_in_world = leaves[leaf].normal; });
  }
  add("a leaf past the last", [&](Border& b) { b.leaf = leaves.size(); });
  add("normal negated", [](Border& b) {
    for (double& component : b.normal_in_world) component = -component;
  });
  add("no normal", [](Border& b) { b.normal_in_world = {}; });
  const double size = size_of(border.normal_in_world);
  const std::vector<Vector> turned = nearby(border.normal_in_world, 6e-8 * size);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(border.normal_in_world[i]) >= 0.9 * size || turned[i] == border.normal_in_world) continue;
    add("normal turned by a float's rounding", [&](Border& b) { b.normal_in_world = turned[i]; });
  }
  if (border.material) add("no material", [](Border& b) { b.material.reset(); });
  for (MaterialIndex material = 0; material < scene.materials.size(); ++material) {
    if (border.material != material) add("another material", [&](Border& b) { b.material = material; });
  }
}

}  // namespace

std::vector<WrongAnswer> wrong_entries(const Scene& scene, const EntryAsk& ask, const EntryAnswer& exact,
                                       const std::vector<Leaf>& admissible) {
  std::vector<WrongAnswer> wrong;
  const auto add = [&](const char* change, const EntryAnswer& answer) { wrong.push_back({change, answer}); };
  if (std::holds_alternative<Miss>(exact)) {
    add("inside for a miss", Inside{ask.lambda_first});
    const std::vector<HalfSpace> leaves = leaves_in_order(scene.shape);
    for (Leaf leaf = 0; leaf < leaves.size(); ++leaf) {
      add("hit for a miss", Border{ask.lambda_first, leaf, leaves[leaf].normal, {}});
      add("hit for a miss", Border{ask.lambda_last, leaf, leaves[leaf].normal, {}});
    }
    return wrong;
  }
  add("miss for a hit", Miss{});
  const auto add_lambdas = [&](auto hit) {
    const double right = hit.lambda;
    const auto at = [&](const char* change, double lambda) {
      hit.lambda = lambda;
      add(change, hit);
    };
    // Four doubles towards 0, where the next binade may be twice as fine.
    at("lambda two ulps late", moved_by(right, right < 0 ? 4 : 2));
    at("lambda two ulps early", moved_by(right, right < 0 ? -2 : -4));
    at("lambda before the range", moved_by(ask.lambda_first, -1));
    at("lambda after the range", moved_by(ask.lambda_last, 1));
    at("lambda rounded to a float's", right + std::ldexp(std::fabs(right), -25) + 1e-30);
  };
  if (const auto* border = std::get_if<Border>(&exact)) {
    add("inside for border", Inside{border->lambda});
    add_lambdas(*border);
    add_wrong_faces(scene, *border, admissible, wrong);
    return wrong;
  }
  add_lambdas(std::get<Inside>(exact));
  const std::vector<HalfSpace> leaves = leaves_in_order(scene.shape);
  for (Leaf leaf = 0; leaf < leaves.size(); ++leaf)
    add("border for inside", Border{std::get<Inside>(exact).lambda, leaf, leaves[leaf].normal, {}});
  return wrong;
}

}  // namespace groundtruth::judge
