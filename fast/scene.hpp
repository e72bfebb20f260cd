#pragma once
// A scene in the form in which fast answers asks about it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <groundtruth/fast/compile_options.hpp>
#include <groundtruth/fast/expression.hpp>
#include <groundtruth/fast/parts.hpp>
#include <groundtruth/problem/scene.hpp>

namespace groundtruth::fast {

// `material` where `region` holds (everywhere, if absent), unless a rule further out has decided.
struct MaterialRule {
  MaterialIndex material = 0;
  std::optional<std::uint32_t> region;      // a place in Scene::regions
  std::optional<std::uint32_t> outer_rule;  // the next one on the way to the root, a place in Scene::rules
};

// The leaves from first_leaf to the next run's have this innermost rule.
struct RuleRun {
  static constexpr std::uint32_t no_rule = 0xffffffff;

  std::uint32_t first_leaf = 0;
  std::uint32_t rule = no_rule;
};

class Scene {
 public:
  // The solid as written; without nodes where all parts are cells (Simplification::written_solid).
  const Expression& solid() const { return solid_; }
  // Of the solid as written.
  std::size_t leaf_count() const { return leaf_count_; }
  const Parts& parts() const { return parts_; }
  const std::vector<Expression>& regions() const { return regions_; }
  // Certainly around each of them.
  const std::vector<Box>& region_boxes() const { return region_boxes_; }
  const std::vector<MaterialRule>& rules() const { return rules_; }
  // The innermost rule of a leaf of the solid, a place in rules().
  std::optional<std::uint32_t> rule_of(std::uint32_t leaf) const;
  const std::vector<RuleRun>& rule_runs() const { return rule_runs_; }
  const std::vector<Material>& materials() const { return materials_; }
  // What compiling dropped, skipped and chosen, and why.
  const std::vector<LeftOut>& left_out() const { return left_out_; }

 private:
  friend class Compiler;
  Scene() = default;

  std::vector<RuleRun>::const_iterator run_of(std::uint32_t leaf) const;

  Expression solid_;
  std::size_t leaf_count_ = 0;
  Parts parts_;
  std::vector<Expression> regions_;
  std::vector<Box> region_boxes_;
  std::vector<MaterialRule> rules_;
  std::vector<RuleRun> rule_runs_;
  std::vector<Material> materials_;
  std::vector<LeftOut> left_out_;
};

// Prepares a scene, once. Requires what every scene owes (SPEC sections 1 and 2: finite numbers, materials
// that exist, no null operand), operators nested at most 1,000 deep and fewer than 2^32 half-spaces.
// Nothing in the result refers to the argument.
Scene compile(const groundtruth::Scene& scene, const CompileOptions& options = {});

}  // namespace groundtruth::fast
