#include <ostream>

#include <groundtruth/tests/properties/shrinking.hpp>
#include <groundtruth/tests/properties/witnesses.hpp>

namespace groundtruth::properties {
namespace {

Shape some_leaf(Dice& dice) {
  if (dice.one_in(16)) return dice.one_in(2) ? Shape{Nothing{}} : Shape{Everything{}};
  const double offset = dice.whole(-3, 3);
  if (dice.one_in(24)) return half_space(0, 0, 0, offset);
  const Vector n = lattice_normal(dice);
  // Twice the normal and the offset are the same plane, written in another way.
  const double factor = dice.one_in(6) ? 2 : 1;
  return half_space(n[0] * factor, n[1] * factor, n[2] * factor, offset * factor);
}

Shape some_box(Dice& dice) {
  const Vector low = lattice_vector(dice, 2);
  Vector high = low;
  for (double& coordinate : high) coordinate += dice.whole(0, 2);
  return box(low, high);
}

Shape sheet(Dice& dice) {
  const Vector n = lattice_normal(dice);
  const double offset = dice.whole(-2, 2);
  return all_of({half_space(n[0], n[1], n[2], offset), half_space(-n[0], -n[1], -n[2], -offset)});
}

Shape some_operation(Dice& dice, int depth) {
  std::vector<Shape> operands;
  for (int count = dice.pick({0, 1, 2, 2, 2, 3, 3, 4}); count > 0; --count) {
    const bool copies = !operands.empty() && dice.one_in(6);
    operands.push_back(copies ? Shape(dice.pick(operands)) : lattice_shape(dice, depth - 1));
  }
  return dice.one_in(2) ? any_of(std::move(operands)) : all_of(std::move(operands));
}

// Of a few lattice points, the one on most planes: where a solid is interesting.
Vector landmark(const std::vector<HalfSpace>& leaves, Dice& dice) {
  Vector best{};
  int most = -1;
  for (int attempt = 0; attempt < 8; ++attempt) {
    const Vector x = lattice_vector(dice, 2);
    int planes = 0;
    for (const auto& [n, d] : leaves) planes += n[0] * x[0] + n[1] * x[1] + n[2] * x[2] == d ? 1 : 0;
    if (planes > most) best = x, most = planes;
  }
  return best;
}

Vector some_direction(const std::vector<HalfSpace>& leaves, Dice& dice) {
  Vector direction = lattice_vector(dice, 2);
  if (leaves.empty() || !dice.one_in(3)) return direction;
  // In the plane of a leaf: across its normal.
  const Vector n = dice.pick(leaves).normal;
  const Vector& v = direction;
  return {n[1] * v[2] - n[2] * v[1], n[2] * v[0] - n[0] * v[2], n[0] * v[1] - n[1] * v[0]};
}

constexpr int odd_numbers_one_in = 24;

void wobble(Vector& vector, Dice& dice) {
  for (double& number : vector) number = wobbled(number, dice, odd_numbers_one_in);
}

EntryCase wild_entry(Dice& dice) {
  EntryCase c{lattice_shape(dice, 2), {}};
  c.ask = lattice_ask(c.shape, dice);
  c.shape = mapped(c.shape, [&dice](HalfSpace h) {
    wobble(h.normal, dice);
    h.offset = wobbled(h.offset, dice, odd_numbers_one_in);
    return h;
  });
  wobble(c.ask.from, dice);
  wobble(c.ask.to, dice);
  double first = wobbled(c.ask.lambda_first, dice, odd_numbers_one_in);
  double last = wobbled(c.ask.lambda_last, dice, odd_numbers_one_in);
  if (last < first) std::swap(first, last);
  c.ask.lambda_first = first;
  c.ask.lambda_last = last;
  return c;
}

}  // namespace

Shape lattice_shape(Dice& dice, int depth) {
  if (depth == 0) return dice.one_in(4) ? some_box(dice) : some_leaf(dice);
  const auto material = static_cast<MaterialIndex>(dice.whole(0, 3));
  switch (dice.whole(0, 11)) {
    case 0:
      return covered(material, lattice_shape(dice, depth - 1));
    case 1:
      return painted(material, lattice_shape(dice, depth - 1), lattice_shape(dice, depth - 1));
    case 2:
      return sheet(dice);
    case 3:
      return some_leaf(dice);
    default:
      return some_operation(dice, depth);
  }
}

EntryAsk lattice_ask(const Shape& shape, Dice& dice) {
  const std::vector<HalfSpace> leaves = leaves_of(shape);
  const Vector at = landmark(leaves, dice);
  const Vector direction = some_direction(leaves, dice);
  const int before = dice.pick({0, 1, 1, 2});
  const int after = dice.pick({0, 1, 2});
  EntryAsk ask{at, at};
  for (std::size_t i = 0; i < 3; ++i) {
    ask.from[i] -= before * direction[i];
    ask.to[i] += after * direction[i];
  }
  if (dice.one_in(3)) {
    ask.lambda_first = dice.whole(-8, 8) / 4.0;
    ask.lambda_last = ask.lambda_first + dice.pick({0, 1, 2, 4, 8, 12}) / 4.0;
  }
  return ask;
}

rc::Gen<EntryCase> lattice_entries() {
  return shrinking([](Dice& dice) {
    EntryCase c{lattice_shape(dice, dice.whole(1, 3)), {}};
    c.ask = lattice_ask(c.shape, dice);
    return c;
  });
}

rc::Gen<EntryCase> cubic_entries() {
  return shrinking([](Dice& dice) {
    EntryCase c{lattice_shape(dice, 2), {}};
    c.shape = mapped(c.shape, [](HalfSpace h) {
      for (double& n : h.normal) n = n > 0 ? 1 : n < 0 ? -1 : 0;
      return h;
    });
    c.ask = lattice_ask(c.shape, dice);
    return c;
  });
}

rc::Gen<EntryCase> wild_entries() { return shrinking(wild_entry); }

void showValue(const EntryCase& c, std::ostream& out) { out << replay({palette(), c.shape}, c.ask); }
void showValue(const StepCase& c, std::ostream& out) { out << replay({palette(), c.shape}, c.ask); }

}  // namespace groundtruth::properties

void groundtruth::showValue(const ClipAsk& ask, std::ostream& out) {
  out << properties::replay({{}, {Nothing{}}}, ask);
}
