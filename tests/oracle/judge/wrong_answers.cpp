#include "wrong_answers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <groundtruth/judge/difference.hpp>

#include "wrong_kinds.hpp"

namespace groundtruth::judge {
namespace {

void collect(const Shape& shape, std::vector<HalfSpace>& leaves) {
  if (const auto* leaf = std::get_if<HalfSpace>(&shape.expression)) leaves.push_back(*leaf);
  if (const auto* of = std::get_if<Union>(&shape.expression))
    for (const Shape& operand : of->operands) collect(operand, leaves);
  if (const auto* of = std::get_if<Intersection>(&shape.expression))
    for (const Shape& operand : of->operands) collect(operand, leaves);
  if (const auto* of = std::get_if<Covered>(&shape.expression)) collect(*of->over, leaves);
  if (const auto* of = std::get_if<Painted>(&shape.expression)) collect(*of->over, leaves);
}

// The same solid, its operands in another order: other leaves are canonical there.
Shape shuffled(const Shape& shape, std::mt19937_64& random) {
  Shape result = shape;
  const auto all = [&](std::vector<Shape>& operands) {
    for (Shape& operand : operands) operand = shuffled(operand, random);
    std::shuffle(operands.begin(), operands.end(), random);
  };
  if (auto* of = std::get_if<Union>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Intersection>(&result.expression)) all(of->operands);
  if (auto* of = std::get_if<Covered>(&result.expression))
    of->over = std::make_shared<const Shape>(shuffled(*of->over, random));
  if (auto* of = std::get_if<Painted>(&result.expression))
    of->over = std::make_shared<const Shape>(shuffled(*of->over, random));
  return result;
}

// Leaving out the numbers, which a change of the numbering never touches.
bool are_alike(const StepAnswer& a, const StepAnswer& b) {
  const Answer one = a, two = b;
  const Difference difference = compare({one, {}}, {two, {}}).difference;
  const bool refuse = std::holds_alternative<Refusal>(a) && std::holds_alternative<Refusal>(b);
  return refuse || difference == Difference::none;
}

}  // namespace

std::vector<HalfSpace> leaves_in_order(const Shape& shape) {
  std::vector<HalfSpace> leaves;
  collect(shape, leaves);
  return leaves;
}

double size_of(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

std::vector<Vector> nearby(const Vector& vector, double change) {
  std::vector<Vector> all;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector moved = vector;
    moved[i] += change + 32 * std::numeric_limits<double>::epsilon() * size_of(vector);
    all.push_back(moved);
  }
  return all;
}

std::vector<Vector> flipped(const Vector& vector, double change) {
  std::vector<Vector> all;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(vector[i]) <= change) continue;
    all.push_back(vector);
    all.back()[i] = -vector[i];
  }
  return all;
}

std::vector<WrongAnswer> wrong_answers(const Scene& scene, const Ask& ask,
                                       const implementations::Answered& exact) {
  if (const auto* entry = std::get_if<EntryAsk>(&ask))
    return wrong_entries(scene, *entry, std::get<EntryAnswer>(exact.answer), exact.evidence.admissible);
  if (const auto* clip = std::get_if<ClipAsk>(&ask))
    return wrong_clips(*clip, std::get<ClipAnswer>(exact.answer));
  return wrong_steps(std::get<StepAsk>(ask), std::get<StepAnswer>(exact.answer));
}

OtherOrders::OtherOrders(const Scene& scene) {
  std::mt19937_64 random(20261126);
  const auto engine = implementations::make_engine("exact");
  for (int i = 0; i < 12; ++i)
    orders_.push_back(engine->on({scene.materials, shuffled(scene.shape, random)}));
}

bool OtherOrders::is_right_on_another_leaf(const Ask& ask, const StepAnswer& got) const {
  return std::any_of(orders_.begin(), orders_.end(), [&](const auto& order) {
    return are_alike(std::get<StepAnswer>(order->answer(ask).answer), got);
  });
}

}  // namespace groundtruth::judge
