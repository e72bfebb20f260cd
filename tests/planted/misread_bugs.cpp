// Mistakes in reading what is rare: regions, names, sizes, limits.

#include <algorithm>
#include <memory>

#include "rewrite.hpp"
#include "ways.hpp"

namespace groundtruth::planted {
namespace {

// Each region of paint is read as another shape.
template <Shape (*change)(const Shape&)>
Scene with_regions(Scene scene) {
  scene.shape = rewritten(scene.shape, [](Shape shape, unsigned) {
    if (auto* paint = std::get_if<Painted>(&shape.expression))
      paint->where = std::make_shared<const Shape>(change(*paint->where));
    return shape;
  });
  return scene;
}

template <typename Kind>
Shape without(const Shape& region) {
  return std::holds_alternative<Kind>(region.expression) ? Shape{Nothing{}} : region;
}

Shape without_empty(const Shape& region) {
  const auto* common = std::get_if<Intersection>(&region.expression);
  return common && common->operands.empty() ? Shape{Nothing{}} : region;
}

Shape without_zero_normals(const Shape& region) {
  const auto* plane = std::get_if<HalfSpace>(&region.expression);
  return plane && plane->normal == Vector{} ? Shape{Nothing{}} : region;
}

Shape first_of_each(const Shape& region) {
  const auto* common = std::get_if<Intersection>(&region.expression);
  return common && !common->operands.empty() ? common->operands.front() : region;
}

// Operands after the first `most` of a union, or an intersection, are read as what changes nothing there.
template <typename Operator, Shape (*as_lost)(Shape), std::size_t most>
Scene operands_up_to(Scene scene) {
  scene.shape = rewritten(scene.shape, [](Shape shape, unsigned) {
    if (auto* of = std::get_if<Operator>(&shape.expression))
      for (std::size_t i = most; i < of->operands.size(); ++i) of->operands[i] = as_lost(of->operands[i]);
    return shape;
  });
  return scene;
}

template <Friction (*change)(Friction)>
Scene with_frictions(Scene scene) {
  for (Material& material : scene.materials) {
    for (auto& [tyre, friction] : material.friction_by_tyre) friction = change(friction);
  }
  return scene;
}

Friction dynamic_below_static(Friction friction) {
  friction.dynamic_coefficient = std::min(friction.dynamic_coefficient, friction.static_coefficient);
  return friction;
}

Friction up_to_one(Friction friction) {
  friction.static_coefficient = std::min(friction.static_coefficient, 1.0);
  friction.dynamic_coefficient = std::min(friction.dynamic_coefficient, 1.0);
  return friction;
}

StepAsk strong_brake(StepAsk ask) {
  ask.brake = std::min(ask.brake, 1e6);
  return ask;
}

StepAsk strut_from_frame(StepAsk ask) {
  ask.wheel.z_min = std::max(ask.wheel.z_min, 0.0);
  return ask;
}

StepAsk tyre_by_six_letters(StepAsk ask) {
  ask.wheel.tyre = ask.wheel.tyre.substr(0, 6);
  return ask;
}

ClipAsk uprightness_from_a_hundredth(ClipAsk ask) {
  ask.min_uprightness = std::max(ask.min_uprightness, 0.01);
  return ask;
}

}  // namespace

std::vector<Bug> misread_bugs() {
  using enum Kind;
  using enum Reach;
  return {
      {"region-everything-is-none", entry, special, "paint everywhere is no paint",
       reads(with_regions<without<Everything>>)},
      {"region-union-is-none", entry, special, "paint on a union is no paint",
       reads(with_regions<without<Union>>)},
      {"region-of-paint-is-none", entry, extreme, "paint on a painted region is no paint",
       reads(with_regions<without<Painted>>)},
      {"region-covered-is-none", entry, extreme, "paint on a region with a material is no paint",
       reads(with_regions<without<Covered>>)},
      {"region-empty-is-none", entry, extreme, "paint on the empty intersection is no paint",
       reads(with_regions<without_empty>)},
      {"region-zero-normal-is-none", entry, extreme, "paint where 0 <= d is no paint",
       reads(with_regions<without_zero_normals>)},
      {"region-by-first-plane", entry, special, "paint on an intersection is paint on its first operand",
       reads(with_regions<first_of_each>)},
      {"unions-up-to-32", entry, special, "the operands of a union after the 32nd are lost",
       reads(operands_up_to<Union, as_nothing, 32>)},
      {"intersections-up-to-16", entry, special, "the operands of an intersection after the 16th are lost",
       reads(operands_up_to<Intersection, as_everything, 16>)},
      {"intersections-up-to-32", entry, extreme, "the operands of an intersection after the 32nd are lost",
       reads(operands_up_to<Intersection, as_everything, 32>)},
      {"dynamic-below-static", step, special, "dynamic friction above static is cut to it",
       reads(with_frictions<dynamic_below_static>)},
      {"scene-friction-up-to-one", step, special, "coefficients of a scene above 1 are cut to 1",
       reads(with_frictions<up_to_one>)},
      {"brake-up-to-a-million", step, special, "a brake beyond 1 MN is cut to it", understands(strong_brake)},
      {"strut-from-frame", step, special, "z_min below 0 is 0", understands(strut_from_frame)},
      {"tyre-by-six-letters", step, extreme, "tyres are told apart by six letters",
       understands(tyre_by_six_letters)},
      {"uprightness-from-a-hundredth", clip, special, "an uprightness below 0.01 is 0.01",
       understands(uprightness_from_a_hundredth)},
  };
}

}  // namespace groundtruth::planted
