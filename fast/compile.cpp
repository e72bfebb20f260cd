#include <algorithm>
#include <map>

#include <groundtruth/fast/cell.hpp>
#include <groundtruth/fast/divide.hpp>
#include <groundtruth/fast/scene.hpp>

namespace groundtruth::fast {

namespace {

// Of the solid: half-spaces of regions are no leaves.
std::size_t count_leaves(const Shape& shape) {
  if (const auto* cover = std::get_if<Covered>(&shape.expression)) return count_leaves(*cover->over);
  if (const auto* paint = std::get_if<Painted>(&shape.expression)) return count_leaves(*paint->over);
  std::size_t count = std::holds_alternative<HalfSpace>(shape.expression) ? 1 : 0;
  const auto add = [&](const std::vector<Shape>& operands) {
    for (const Shape& operand : operands) count += count_leaves(operand);
  };
  if (const auto* all = std::get_if<Union>(&shape.expression)) add(all->operands);
  if (const auto* all = std::get_if<Intersection>(&shape.expression)) add(all->operands);
  return count;
}

// The operator whose operands are being laid out.
struct Operator {
  NodeKind kind = NodeKind::union_of;
  std::optional<std::size_t> last_operand;  // where it starts

  bool ends_in_cell(const std::vector<Node>& nodes) const {
    return last_operand && *last_operand + 1 == nodes.size() && nodes.back().kind == NodeKind::cell;
  }
};

}  // namespace

class Compiler {
 public:
  Compiler(const groundtruth::Scene& scene, const CompileOptions& options) : options_(options) {
    scene_.materials_ = scene.materials;
    Site site{scene_.solid_, Role::solid, std::nullopt};
    scene_.solid_.leaves.reserve(count_leaves(scene.shape));
    operate(site, NodeKind::union_of, [&](Operator& op) { add(site, scene.shape, op); });
    if (options.has(Simplification::constants)) fold_constants();
    if (hidden_rules_ > 0)
      scene_.left_out_.push_back(
          {Simplification::hidden_rules, hidden_rules_, "materials and paints under a material"});
    for (const Expression& region : scene_.regions_)
      scene_.region_boxes_.push_back(box_around(region, region.nodes.data()));
    scene_.parts_ = divide(scene_.solid_, options, scene_.left_out_);
    if (options.has(Simplification::known_materials)) settle_materials();
    scene_.leaf_count_ = scene_.solid_.leaves.size();
    if (options.has(Simplification::written_solid) && scene_.parts_.general.empty()) forget_solid();
  }

  Scene result() {
    scene_.solid_.nodes.shrink_to_fit();
    scene_.rule_runs_.shrink_to_fit();
    scene_.rules_.shrink_to_fit();
    return std::move(scene_);
  }

 private:
  enum class Role { solid, region };

  // Where half-spaces go, and the material rule that holds for them.
  struct Site {
    Expression& expression;
    Role role;
    std::optional<std::uint32_t> rule;
  };

  void fold_constants() {
    std::vector<Node> folded = fold(scene_.solid_);
    if (folded.size() < scene_.solid_.nodes.size())
      scene_.left_out_.push_back({Simplification::constants, scene_.solid_.nodes.size() - folded.size(),
                                  "constants, and operators that they decide"});
    scene_.solid_.nodes = std::move(folded);
  }

  void forget_solid() {
    scene_.left_out_.push_back(
        {Simplification::written_solid, scene_.leaf_count_, "half-spaces not kept beside the cells"});
    scene_.solid_ = {};
  }

  // Where one material, or none, covers a cell whatever the point, the cell bears it. Else its rule, if it
  // has one alone.
  void settle_materials() {
    const PackedCells& cells = scene_.parts_.cells;
    std::size_t known = 0, remote = 0;
    for (Cell& cell : scene_.parts_.cells.cells) {
      if (cell.leaf_count == 0) continue;
      // Leaves ascend in a cell.
      const auto first = scene_.run_of(cell.first_leaf);
      const std::uint32_t last_leaf = cells.leaf_at(cell, cell.leaf_count - 1);
      if (std::next(first) != scene_.rule_runs_.end() && std::next(first)->first_leaf <= last_leaf) continue;
      cell.material = material_by(innermost_in_reach(cell, first->rule, remote));
      known += cell.material.material != CellMaterial::by_rules;
    }
    const auto note = [&](Simplification what, std::size_t count, const char* why) {
      if (count > 0) scene_.left_out_.push_back({what, count, why});
    };
    note(Simplification::known_materials, known, "cells of one material, or none: no rules for their hits");
    note(Simplification::remote_paints, remote, "paints of cells that they do not reach");
  }

  // A paint whose region holds no point of the cell decides nothing there: the next further out may.
  std::uint32_t innermost_in_reach(const Cell& cell, std::uint32_t rule, std::size_t& skipped) const {
    constexpr int most_skipped = 8;  // of one cell, to bound the time
    if (!options_.has(Simplification::remote_paints)) return rule;
    for (int i = 0; i != most_skipped && rule != RuleRun::no_rule; ++i) {
      const MaterialRule& at = scene_.rules_[rule];
      if (!at.region || !is_apart(scene_.parts_.cells, cell, scene_.region_boxes_[*at.region])) break;
      rule = at.outer_rule.value_or(RuleRun::no_rule);
      ++skipped;
    }
    return rule;
  }

  CellMaterial material_by(std::uint32_t rule) const {
    if (rule == RuleRun::no_rule) return {CellMaterial::none, CellMaterial::unknown_rule};
    const MaterialRule& at = scene_.rules_[rule];
    if (at.region || at.outer_rule) return {CellMaterial::by_rules, rule};
    return {static_cast<std::uint32_t>(at.material), rule};
  }

  void note_rule(std::uint32_t leaf, std::uint32_t rule) {
    if (scene_.rule_runs_.empty() || scene_.rule_runs_.back().rule != rule)
      scene_.rule_runs_.push_back({leaf, rule});
  }

  // Lays out an operator whose operands `add_operands` adds; one with a single operand is that operand.
  template <class AddOperands>
  static void operate(const Site& site, NodeKind kind, AddOperands add_operands) {
    std::vector<Node>& nodes = site.expression.nodes;
    const std::size_t place = nodes.size();
    nodes.push_back({.kind = kind});
    Operator op{.kind = kind, .last_operand = std::nullopt};
    add_operands(op);
    const std::size_t below = nodes.size() - place - 1;
    if (below > 0 && nodes[place + 1].size == below)
      nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(place));
    else
      nodes[place].size = static_cast<std::uint32_t>(below + 1);
  }

  void add(const Site& site, const Shape& shape, Operator& op) {
    std::visit([&](const auto& expression) { this->add(site, expression, op); }, shape.expression);
  }

  void add(const Site& site, const Everything&, Operator& op) { add_node(site, NodeKind::everything, op); }
  void add(const Site& site, const Nothing&, Operator& op) { add_node(site, NodeKind::nothing, op); }

  void add(const Site& site, const HalfSpace& half_space, Operator& op) {
    const auto leaf = static_cast<std::uint32_t>(site.expression.leaves.size());
    site.expression.leaves.push_back(half_space);
    if (site.role == Role::solid) note_rule(leaf, site.rule.value_or(RuleRun::no_rule));
    if (op.kind != NodeKind::intersection_of || !op.ends_in_cell(site.expression.nodes)) {
      add_node(site, NodeKind::cell, op);
      site.expression.nodes.back().first_leaf = leaf;
    }
    site.expression.nodes.back().end_leaf = leaf + 1;
  }

  void add(const Site& site, const Union& shape, Operator& op) {
    add_operator(site, NodeKind::union_of, shape.operands, op);
  }
  void add(const Site& site, const Intersection& shape, Operator& op) {
    add_operator(site, NodeKind::intersection_of, shape.operands, op);
  }

  void add(const Site& site, const Covered& cover, Operator& op) {
    add_under_rule(site, {.material = cover.material, .region = std::nullopt, .outer_rule = site.rule},
                   *cover.over, op);
  }

  void add(const Site& site, const Painted& paint, Operator& op) {
    if (site.role == Role::region) return add(site, *paint.over, op);
    if (is_hidden(site)) {
      ++hidden_rules_;
      return add(site, *paint.over, op);
    }
    const auto region = static_cast<std::uint32_t>(scene_.regions_.size());
    scene_.regions_.emplace_back();
    Expression expression;
    const Site where{expression, Role::region, std::nullopt};
    operate(where, NodeKind::union_of, [&](Operator& root) { add(where, *paint.where, root); });
    scene_.regions_[region] = std::move(expression);
    add_under_rule(site, {.material = paint.material, .region = region, .outer_rule = site.rule}, *paint.over,
                   op);
  }

  // The innermost rule so far covers all: it decides wherever none further out does.
  bool is_hidden(const Site& site) const {
    return options_.has(Simplification::hidden_rules) && site.rule && !scene_.rules_[*site.rule].region;
  }

  void add_under_rule(const Site& site, const MaterialRule& rule, const Shape& over, Operator& op) {
    if (site.role == Role::region) return add(site, over, op);
    if (is_hidden(site)) {
      ++hidden_rules_;
      return add(site, over, op);
    }
    add(Site{site.expression, site.role, number_of(rule)}, over, op);
  }

  // A rule without a region that is like an earlier one is that one.
  std::uint32_t number_of(const MaterialRule& rule) {
    const auto next = static_cast<std::uint32_t>(scene_.rules_.size());
    if (!rule.region) {
      const std::pair key{rule.material, rule.outer_rule};
      const auto [at, is_new] = rule_without_region_.try_emplace(key, next);
      if (!is_new) return at->second;
    }
    scene_.rules_.push_back(rule);
    return next;
  }

  void add_operator(const Site& site, NodeKind kind, const std::vector<Shape>& operands, Operator& op) {
    if (kind == op.kind) {
      for (const Shape& operand : operands) add(site, operand, op);
      return;
    }
    op.last_operand = site.expression.nodes.size();
    operate(site, kind, [&](Operator& own) {
      for (const Shape& operand : operands) add(site, operand, own);
    });
  }

  static void add_node(const Site& site, NodeKind kind, Operator& op) {
    op.last_operand = site.expression.nodes.size();
    site.expression.nodes.push_back({.kind = kind});
  }

  const CompileOptions& options_;
  std::size_t hidden_rules_ = 0;
  std::map<std::pair<MaterialIndex, std::optional<std::uint32_t>>, std::uint32_t> rule_without_region_;
  Scene scene_;
};

std::vector<RuleRun>::const_iterator Scene::run_of(std::uint32_t leaf) const {
  return std::prev(
      std::upper_bound(rule_runs_.begin(), rule_runs_.end(), leaf,
                       [](std::uint32_t number, const RuleRun& run) { return number < run.first_leaf; }));
}

std::optional<std::uint32_t> Scene::rule_of(std::uint32_t leaf) const {
  const std::uint32_t rule = run_of(leaf)->rule;
  return rule == RuleRun::no_rule ? std::nullopt : std::optional(rule);
}

Scene compile(const groundtruth::Scene& scene, const CompileOptions& options) {
  return Compiler(scene, options).result();
}

}  // namespace groundtruth::fast
