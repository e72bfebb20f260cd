// Random nested shapes on a lattice, where doubles are exact: fast must agree with the witness entirely.

#include <random>
#include <sstream>

#include <gtest/gtest.h>
#include <groundtruth/fast/entry_point.hpp>
#include <groundtruth/tests/fast/lattice_witness.hpp>

namespace groundtruth {
namespace {

std::string text(const Shape& shape);

std::string text(const std::vector<Shape>& operands) {
  std::string all;
  for (const Shape& operand : operands) all += (all.empty() ? "" : ", ") + text(operand);
  return all;
}

std::string text(const Shape& shape) {
  std::ostringstream out;
  if (std::holds_alternative<Everything>(shape.expression)) out << "everything";
  if (std::holds_alternative<Nothing>(shape.expression)) out << "nothing";
  if (const auto* h = std::get_if<HalfSpace>(&shape.expression))
    out << "[" << h->normal[0] << " " << h->normal[1] << " " << h->normal[2] << " " << h->offset << "]";
  if (const auto* u = std::get_if<Union>(&shape.expression)) out << "union(" << text(u->operands) << ")";
  if (const auto* i = std::get_if<Intersection>(&shape.expression))
    out << "intersection(" << text(i->operands) << ")";
  if (const auto* c = std::get_if<Covered>(&shape.expression))
    out << "cover(" << c->material << ", " << text(*c->over) << ")";
  if (const auto* p = std::get_if<Painted>(&shape.expression))
    out << "paint(" << p->material << ", " << text(*p->where) << ", " << text(*p->over) << ")";
  return out.str();
}

std::string text(const EntryAnswer& answer) {
  std::ostringstream out;
  if (std::holds_alternative<Miss>(answer)) out << "miss";
  if (const auto* inside = std::get_if<Inside>(&answer)) out << "inside " << inside->lambda;
  if (const auto* border = std::get_if<Border>(&answer))
    out << "border " << border->lambda << " leaf " << border->leaf << " material "
        << (border->material ? std::to_string(*border->material) : "none");
  return out.str();
}

class Chooser {
 public:
  explicit Chooser(std::uint64_t seed) : engine_(seed) {}

  int between(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  double lattice(int limit) { return between(-limit, limit); }
  Vector vector(int limit) { return {lattice(limit), lattice(limit), lattice(limit)}; }

  Shape shape(int depth) {
    const int choice = between(0, depth > 0 ? 11 : 1);
    if (choice == 11) return between(0, 1) ? Shape{Everything{}} : Shape{Nothing{}};
    if (choice == 10)
      return {Painted{std::size_t(between(0, 3)), std::make_shared<Shape>(shape(depth - 1)),
                      std::make_shared<Shape>(shape(depth - 1))}};
    if (choice == 9) return {Covered{std::size_t(between(0, 3)), std::make_shared<Shape>(shape(depth - 1))}};
    if (choice >= 6) return {Union{operands(depth - 1)}};
    if (choice >= 2) return {Intersection{operands(depth - 1)}};
    return {HalfSpace{vector(1), lattice(1)}};
  }

  EntryAsk ask() {
    const std::pair<double, double> ranges[] = {{0, 1}, {0, 1}, {0, 1}, {-1, 2}, {0.25, 0.75}, {0.5, 0.5}};
    const auto [first, last] = ranges[between(0, 5)];
    return {vector(2), vector(2), first, last};
  }

 private:
  std::vector<Shape> operands(int depth) {
    std::vector<Shape> all;
    for (int count = between(0, 9) ? between(1, 4) : 0; count > 0; --count) all.push_back(shape(depth));
    return all;
  }

  std::mt19937_64 engine_;
};

void expect_the_witness_answer(const Scene& scene, const fast::Scene& compiled, const EntryAsk& ask) {
  const EntryAnswer expected = lattice::Witness(scene, ask).answer();
  const EntryAnswer got = fast::entry_point(compiled, ask);
  ASSERT_EQ(got, expected) << text(scene.shape) << "\nfrom (" << ask.from[0] << " " << ask.from[1] << " "
                           << ask.from[2] << ") to (" << ask.to[0] << " " << ask.to[1] << " " << ask.to[2]
                           << ") range " << ask.lambda_first << " " << ask.lambda_last << "\ngot "
                           << text(got) << ", expected " << text(expected);
}

class FastNestedShapes : public testing::TestWithParam<int> {};

TEST_P(FastNestedShapes, AreAnsweredAsByEnumerationInIntegers) {
  Chooser chooser(static_cast<std::uint64_t>(20240 + GetParam()));
  const int scenes = 2000;
  std::size_t kinds[3] = {};
  for (int i = 0; i < scenes; ++i) {
    const Scene scene{{}, chooser.shape(GetParam())};
    const fast::Scene compiled = fast::compile(scene);
    for (int j = 0; j < 4; ++j) {
      const EntryAsk ask = chooser.ask();
      ASSERT_NO_FATAL_FAILURE(expect_the_witness_answer(scene, compiled, ask)) << "scene " << i;
      ++kinds[fast::entry_point(compiled, ask).index()];
    }
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 100u) << "the asks cover too little";
}

INSTANTIATE_TEST_SUITE_P(Depth, FastNestedShapes, testing::Values(1, 2, 3, 4, 5));

// Seams, sheets, edges and covered corners are common when planes are few.
TEST(FastUnionsOfBoxes, OnOneLatticeAreAnsweredAsByEnumerationInIntegers) {
  Chooser chooser(7);
  for (int i = 0; i < 3000; ++i) {
    Union boxes;
    for (int count = chooser.between(1, 5); count > 0; --count) {
      Intersection box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = chooser.lattice(1), high = low + chooser.between(0, 1);
        Vector normal{};
        normal[axis] = -1;
        box.operands.push_back({HalfSpace{normal, -low}});
        normal[axis] = 1;
        box.operands.push_back({HalfSpace{normal, high}});
      }
      boxes.operands.push_back({box});
    }
    const Scene scene{{}, {boxes}};
    const fast::Scene compiled = fast::compile(scene);
    for (int j = 0; j < 4; ++j)
      ASSERT_NO_FATAL_FAILURE(expect_the_witness_answer(scene, compiled, chooser.ask())) << "scene " << i;
  }
}

}  // namespace
}  // namespace groundtruth
