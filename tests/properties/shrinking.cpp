#include <groundtruth/tests/properties/shrinking.hpp>

#include <cmath>
#include <cstdint>

namespace groundtruth::properties {
namespace {

using Numbers = std::vector<double*>;

// The value with one of its numbers replaced by a simpler one.
template <typename Value>
void simplify_numbers(const Value& value, Numbers (*numbers_of)(Value&), std::vector<Value>& out) {
  Value copy = value;
  const std::size_t count = numbers_of(copy).size();
  for (std::size_t i = 0; i < count; ++i) {
    for (const double number : simpler(*numbers_of(copy)[i])) {
      out.push_back(value);
      *numbers_of(out.back())[i] = number;
    }
  }
}

void append(Numbers& numbers, Vector& vector) {
  for (double& number : vector) numbers.push_back(&number);
}

Numbers numbers_of_half_space(HalfSpace& h) { return {&h.normal[0], &h.normal[1], &h.normal[2], &h.offset}; }

Numbers numbers_of_clip(ClipAsk& ask) {
  Numbers numbers;
  append(numbers, ask.force_in_wheel);
  append(numbers, ask.normal_in_wheel);
  numbers.insert(numbers.end(), {&ask.friction, &ask.brake});
  return numbers;
}

// Not the wheel's: what is legal of those hangs together.
Numbers numbers_of_step(StepAsk& ask) {
  Numbers numbers{&ask.brake};
  append(numbers, ask.frame.position_in_world);
  append(numbers, ask.frame.velocity_in_world);
  append(numbers, ask.frame.angular_velocity_in_world);
  if (auto* contact = std::get_if<Contact>(&ask.state)) {
    append(numbers, contact->pebble_in_world);
    append(numbers, contact->pebble_velocity_in_world);
    append(numbers, contact->normal_in_world);
    numbers.insert(numbers.end(), {&contact->static_friction, &contact->dynamic_friction});
  }
  return numbers;
}

template <typename Case>
void simplify_shape(const Case& c, std::vector<Case>& out) {
  for (Shape& shape : simpler(c.shape)) {
    out.push_back(c);
    out.back().shape = std::move(shape);
  }
}

}  // namespace

std::vector<double> simpler(double value) {
  if (value == 0) return {};
  std::vector<double> out{0};
  if (std::fabs(value) != 1) out.push_back(1);
  if (value < 0) out.push_back(-value);
  const bool is_small = std::fabs(value) < 0x1p20 && std::fabs(value) > 0x1p-20;
  if (!is_small || std::fabs(value) <= 1) return out;
  if (std::trunc(value) != value) {
    out.push_back(std::trunc(value));
    const double rounded = std::ldexp(std::trunc(std::ldexp(value, 4)), -4);
    if (rounded != value) out.push_back(rounded);
  } else {
    out.push_back(std::trunc(value / 2));
    out.push_back(value - std::copysign(1, value));
  }
  return out;
}

std::vector<EntryCase> simpler(const EntryCase& c) {
  std::vector<EntryCase> out;
  simplify_shape(c, out);
  if (c.ask.lambda_first != 0 || c.ask.lambda_last != 1) {
    out.push_back(c);
    out.back().ask.lambda_first = 0;
    out.back().ask.lambda_last = 1;
  }
  simplify_numbers<EntryCase>(
      c,
      [](EntryCase& entry) {
        Numbers numbers;
        append(numbers, entry.ask.from);
        append(numbers, entry.ask.to);
        return numbers;
      },
      out);
  return out;
}

std::vector<ClipAsk> simpler(const ClipAsk& ask) {
  std::vector<ClipAsk> out;
  simplify_numbers<ClipAsk>(ask, numbers_of_clip, out);
  return out;
}

std::vector<StepCase> simpler(const StepCase& c) {
  std::vector<StepCase> out;
  simplify_shape(c, out);
  if (c.ask.frame.world_from_wheel != Quaternion{1, 0, 0, 0}) {
    out.push_back(c);
    out.back().ask.frame.world_from_wheel = {1, 0, 0, 0};
  }
  simplify_numbers<StepCase>(
      c, [](StepCase& s) { return numbers_of_step(s.ask); }, out);
  return out;
}

std::vector<Shape> simpler(const Shape& shape) {
  if (std::holds_alternative<Everything>(shape.expression)) return {{Nothing{}}};
  if (std::holds_alternative<Nothing>(shape.expression)) return {};
  if (const auto* h = std::get_if<HalfSpace>(&shape.expression)) {
    std::vector<HalfSpace> half_spaces;
    simplify_numbers<HalfSpace>(*h, numbers_of_half_space, half_spaces);
    std::vector<Shape> out{{Nothing{}}, {Everything{}}};
    for (const HalfSpace& half_space : half_spaces) out.push_back({half_space});
    return out;
  }
  if (const auto* c = std::get_if<Covered>(&shape.expression)) {
    std::vector<Shape> out{*c->over};
    for (Shape& over : simpler(*c->over)) out.push_back(covered(c->material, std::move(over)));
    return out;
  }
  if (const auto* p = std::get_if<Painted>(&shape.expression)) {
    std::vector<Shape> out{*p->over};
    for (Shape& over : simpler(*p->over)) out.push_back(painted(p->material, *p->where, std::move(over)));
    for (Shape& where : simpler(*p->where)) out.push_back(painted(p->material, std::move(where), *p->over));
    return out;
  }
  const std::vector<Shape> operands = operands_of(shape);
  std::vector<Shape> out = operands;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    std::vector<Shape> fewer = operands;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    out.push_back(with_operands(shape, std::move(fewer)));
  }
  for (std::size_t i = 0; i < operands.size(); ++i) {
    for (Shape& operand : simpler(operands[i])) {
      std::vector<Shape> changed = operands;
      changed[i] = std::move(operand);
      out.push_back(with_operands(shape, std::move(changed)));
    }
  }
  return out;
}

}  // namespace groundtruth::properties
