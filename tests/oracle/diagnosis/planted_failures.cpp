#include "planted_failures.hpp"

#include <algorithm>
#include <memory>

#include <groundtruth/cases/ask_source.hpp>
#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/cases/shape_parts.hpp>
#include <groundtruth/implementations/engine.hpp>

namespace groundtruth::diagnosis {
namespace {

implementations::Answered exactly(const Scene& scene, const Ask& ask) {
  return implementations::make_engine("exact")->on(scene)->answer(ask);
}

const Border* border_of(const Answer& answer) {
  const auto* entry = std::get_if<EntryAnswer>(&answer);
  return entry == nullptr ? nullptr : std::get_if<Border>(entry);
}

void collect_normals(const Shape& shape, std::vector<Vector>& normals) {
  if (const auto* leaf = std::get_if<HalfSpace>(&shape.expression)) normals.push_back(leaf->normal);
  if (const auto* cover = std::get_if<Covered>(&shape.expression)) collect_normals(*cover->over, normals);
  if (const auto* paint = std::get_if<Painted>(&shape.expression)) collect_normals(*paint->over, normals);
  const auto of_operands = [&](const auto* op) {
    if (op != nullptr)
      for (const Shape& operand : op->operands) collect_normals(operand, normals);
  };
  of_operands(std::get_if<Union>(&shape.expression));
  of_operands(std::get_if<Intersection>(&shape.expression));
}

// In doubles: the test's scenes have short numbers where it matters.
bool are_parallel(const Vector& a, const Vector& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

Shape without_paint(const Shape& shape) {
  const auto of_operands = [](auto op) {
    for (Shape& operand : op.operands) operand = without_paint(operand);
    return Shape{std::move(op)};
  };
  if (const auto* either = std::get_if<Union>(&shape.expression)) return of_operands(*either);
  if (const auto* both = std::get_if<Intersection>(&shape.expression)) return of_operands(*both);
  if (const auto* paint = std::get_if<Painted>(&shape.expression)) return without_paint(*paint->over);
  if (const auto* cover = std::get_if<Covered>(&shape.expression))
    return {Covered{cover->material, std::make_shared<Shape>(without_paint(*cover->over))}};
  return shape;
}

}  // namespace

StillFail each(Fails fails) {
  return [fails](std::span<const cases::Case> candidates) {
    std::vector<bool> result;
    for (const cases::Case& candidate : candidates) result.push_back(fails(candidate));
    return result;
  };
}

bool has_corner(const cases::Case& with) {
  if (!std::holds_alternative<EntryAsk>(with.ask)) return false;
  const auto answered = exactly(with.scene, with.ask);
  if (border_of(answered.answer) == nullptr) return false;
  std::vector<Vector> all, meeting;
  collect_normals(with.scene.shape, all);
  for (const Leaf leaf : answered.evidence.admissible) {
    const Vector& normal = all[leaf];
    if (std::ranges::none_of(meeting, [&](const Vector& known) { return are_parallel(known, normal); }))
      meeting.push_back(normal);
  }
  return meeting.size() >= 3;
}

bool has_range_start(const cases::Case& with) {
  const auto* ask = std::get_if<EntryAsk>(&with.ask);
  return ask != nullptr && ask->lambda_first != 0;
}

bool has_brake_at_limit(const cases::Case& with) {
  const auto* ask = std::get_if<ClipAsk>(&with.ask);
  return ask != nullptr && ask->brake > 0 && ask->brake == ask->friction * ask->force_in_wheel[2];
}

bool has_paint(const cases::Case& with) {
  if (!std::holds_alternative<EntryAsk>(with.ask)) return false;
  const Answer answer = exactly(with.scene, with.ask).answer;
  if (border_of(answer) == nullptr) return false;
  return answer != exactly({with.scene.materials, without_paint(with.scene.shape)}, with.ask).answer;
}

bool slips_and_turns(const cases::Case& with) {
  const auto* ask = std::get_if<StepAsk>(&with.ask);
  if (ask == nullptr || ask->frame.angular_velocity_in_world == Vector{}) return false;
  const auto* contact = std::get_if<Contact>(&ask->state);
  return contact != nullptr && contact->grip == Grip::slip;
}

std::vector<cases::Case> messy_cases(Fails fails, std::size_t most, std::size_t most_leaves) {
  std::vector<cases::Case> found;
  for (const cases::BuiltinScene& builtin : cases::builtin_scenes()) {
    for (const Scene& scene : builtin.build()) {
      if (cases::leaf_count(scene.shape) > most_leaves) continue;
      cases::AskSource source(scene, 1);
      std::size_t here = 0;
      for (int i = 0; i < 100 && here < 2 && found.size() < most; ++i) {
        cases::Case one{"", scene, source.next().ask, {}, ""};
        if (!fails(one)) continue;
        found.push_back(std::move(one));
        ++here;
      }
    }
  }
  return found;
}

}  // namespace groundtruth::diagnosis
