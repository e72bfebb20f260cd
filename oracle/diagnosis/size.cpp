#include <groundtruth/diagnosis/size.hpp>

#include <cmath>

#include <groundtruth/diagnosis/inputs.hpp>

namespace groundtruth::diagnosis {
namespace {

// Significant bits of a number that is not 0.
int bits_of(double number) {
  int exponent = 0;
  auto mantissa = static_cast<long long>(std::ldexp(std::frexp(std::abs(number), &exponent), 53));
  int bits = 53;
  while (bits > 1 && mantissa % 2 == 0) {
    mantissa /= 2;
    --bits;
  }
  return bits;
}

// What a reader expects costs him nothing.
bool is_usual(const std::string& name, double number) {
  if (name == "range[1]" || name == "frame.orientation[0]") return number == 1;
  return name.ends_with("min_uprightness") && number == default_min_uprightness;
}

struct CountParts {
  Size& size;
  void operator()(const Shape& shape) {
    ++size.parts;
    std::visit(*this, shape.expression);
  }
  void operator()(const Everything&) {}
  void operator()(const Nothing&) {}
  void operator()(const HalfSpace&) { ++size.leaves; }
  void operator()(const Union& shape) {
    for (const Shape& operand : shape.operands) (*this)(operand);
  }
  void operator()(const Intersection& shape) {
    for (const Shape& operand : shape.operands) (*this)(operand);
  }
  void operator()(const Covered& cover) { (*this)(*cover.over); }
  void operator()(const Painted& paint) {
    (*this)(*paint.where);
    (*this)(*paint.over);
  }
};

}  // namespace

double cost_of(double number) {
  if (number == 0) return 0;
  const double sign = number < 0 ? 0.25 : 0;
  const double size = std::abs(number);
  if (size == 1) return 1 + sign;
  if (size == std::floor(size) && size < 1024) return 2 + std::log2(size) / 4 + sign;
  return 5 + bits_of(number) + std::abs(std::log2(size)) / 4 + sign;
}

Size size_of(const cases::Case& with) {
  Size size;
  CountParts count{size};
  count(with.scene.shape);
  size.parts += with.scene.materials.empty() ? 0 : 1;
  if (const auto* step = std::get_if<StepAsk>(&with.ask)) {
    size.parts += std::holds_alternative<Contact>(step->state) ? 2 : 0;
    size.parts += step->wheel.relocation == Relocation::return_mapping ? 1 : 0;
  }
  cases::Case copy = with;
  for_each_number(copy, [&](const std::string& name, double& number) {
    size.numbers += is_usual(name, number) ? 0 : cost_of(number);
  });
  return size;
}

}  // namespace groundtruth::diagnosis
