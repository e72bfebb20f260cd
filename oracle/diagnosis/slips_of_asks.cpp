#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <groundtruth/diagnosis/inputs.hpp>
#include <groundtruth/diagnosis/slips.hpp>

namespace groundtruth::diagnosis {
namespace {

template <class AskKind, class Change>
void in(Ask& ask, Change change) {
  if (auto* kind = std::get_if<AskKind>(&ask)) change(*kind);
}

template <class Change>
void in_contact(Ask& ask, Change change) {
  in<StepAsk>(ask, [&](StepAsk& step) {
    if (auto* contact = std::get_if<Contact>(&step.state)) change(*contact);
  });
}

void in_numbers(Scene& scene, Ask& ask, const std::function<void(const std::string&, double&)>& change) {
  cases::Case with{{}, scene, ask, {}, {}};
  for_each_number(with, change);
  scene = std::move(with.scene);
  ask = std::move(with.ask);
}

void round_to_float(Scene& scene, Ask& ask) {
  in_numbers(scene, ask, [](const std::string&, double& number) {
    const double rounded = static_cast<float>(number);
    if (std::isfinite(rounded) && (rounded != 0 || number == 0)) number = rounded;
  });
}

void open_half_spaces(Scene& scene, Ask& ask) {
  in_numbers(scene, ask, [](const std::string& name, double& number) {
    if (name.ends_with("offset")) number = std::nextafter(number, -std::numeric_limits<double>::infinity());
  });
}

// As if |q| were 1: what is turned into the wheel is |q|^2 as long, and so is what is turned back.
void forget_quaternion_length(Scene&, Ask& ask) {
  in<StepAsk>(ask, [](StepAsk& step) {
    double norm = 0;
    for (const double x : step.frame.world_from_wheel) norm += x * x;
    const double length = std::holds_alternative<Contact>(step.state) ? 1 / norm : norm;
    for (double* z : {&step.wheel.z_min, &step.wheel.z_zero, &step.wheel.z_max}) *z *= length;
    if (!std::holds_alternative<Contact>(step.state)) return;
    for (double* k : {&step.wheel.k_xy, &step.wheel.k_z, &step.wheel.d_xy, &step.wheel.d_z}) *k *= norm;
  });
}

void swap_frictions(Scene& scene, Ask& ask) {
  for (Material& material : scene.materials)
    for (auto& [tyre, friction] : material.friction_by_tyre)
      std::swap(friction.static_coefficient, friction.dynamic_coefficient);
  in_contact(ask, [](Contact& contact) { std::swap(contact.static_friction, contact.dynamic_friction); });
}

using Rules = std::vector<std::function<Shape(Shape)>>;

// The shape with its material rules, and those met on the way to it, laid around each leaf, the outermost
// innermost.
Shape turned_inside_out(const Shape& shape, Rules& rules) {
  const auto each = [&](auto op) {
    for (Shape& operand : op.operands) operand = turned_inside_out(operand, rules);
    return Shape{std::move(op)};
  };
  const auto under = [&](const Shape& over, std::function<Shape(Shape)> rule) {
    rules.push_back(std::move(rule));
    Shape result = turned_inside_out(over, rules);
    rules.pop_back();
    return result;
  };
  if (const auto* op = std::get_if<Union>(&shape.expression)) return each(*op);
  if (const auto* op = std::get_if<Intersection>(&shape.expression)) return each(*op);
  if (const auto* cover = std::get_if<Covered>(&shape.expression))
    return under(*cover->over, [material = cover->material](Shape over) {
      return Shape{Covered{material, std::make_shared<Shape>(std::move(over))}};
    });
  if (const auto* paint = std::get_if<Painted>(&shape.expression))
    return under(*paint->over, [material = paint->material, where = paint->where](Shape over) {
      return Shape{Painted{material, where, std::make_shared<Shape>(std::move(over))}};
    });
  Shape leaf = shape;
  for (const auto& rule : rules) leaf = rule(std::move(leaf));
  return leaf;
}

void let_innermost_material_win(Scene& scene, Ask&) {
  Rules rules;
  scene.shape = turned_inside_out(scene.shape, rules);
}

constexpr AskSlip slips[] = {
    {"strict-comparison", "half-spaces are taken as open: what only touches is missed", open_half_spaces},
    {"ignored-range", "the whole segment is asked about, whatever the range says",
     [](Scene&, Ask& ask) {
       in<EntryAsk>(ask, [](EntryAsk& entry) { entry.lambda_first = 0, entry.lambda_last = 1; });
     }},
    {"ignored-range-start", "the range is taken to start at 0",
     [](Scene&, Ask& ask) {
       in<EntryAsk>(ask, [](EntryAsk& entry) { entry.lambda_first = std::min(0.0, entry.lambda_last); });
     }},
    {"ignored-range-end", "the range is taken to end at 1",
     [](Scene&, Ask& ask) {
       in<EntryAsk>(ask, [](EntryAsk& entry) { entry.lambda_last = std::max(1.0, entry.lambda_first); });
     }},
    {"float-inputs", "numbers are read as 32-bit floats", round_to_float},
    {"quaternion-length", "the quaternion is not normalised", forget_quaternion_length},
    {"transposed-rotation", "world and wheel are exchanged: the inverse rotation is used",
     [](Scene&, Ask& ask) {
       in<StepAsk>(ask, [](StepAsk& step) {
         for (std::size_t i = 1; i < 4; ++i)
           step.frame.world_from_wheel[i] = 0 - step.frame.world_from_wheel[i];
       });
     }},
    {"swapped-frictions", "static and dynamic friction are exchanged", swap_frictions},
    {"static-friction-only", "the static coefficient is used in slip too",
     [](Scene&, Ask& ask) {
       in_contact(ask, [](Contact& contact) { contact.dynamic_friction = contact.static_friction; });
     }},
    {"dynamic-friction-only", "the dynamic coefficient is used in stick too",
     [](Scene&, Ask& ask) {
       in_contact(ask, [](Contact& contact) { contact.static_friction = contact.dynamic_friction; });
     }},
    {"innermost-material", "the innermost material wins instead of the outermost",
     let_innermost_material_win},
    {"uprightness-not-checked", "min_uprightness is not looked at",
     [](Scene&, Ask& ask) {
       in<ClipAsk>(ask, [](ClipAsk& clip) { clip.min_uprightness = 1e-12; });
       in<StepAsk>(ask, [](StepAsk& step) { step.wheel.min_uprightness = 1e-12; });
     }},
    {"uprightness-by-default", "min_uprightness is taken to be 0.1",
     [](Scene&, Ask& ask) {
       in<ClipAsk>(ask, [](ClipAsk& clip) { clip.min_uprightness = default_min_uprightness; });
       in<StepAsk>(ask, [](StepAsk& step) { step.wheel.min_uprightness = default_min_uprightness; });
     }},
    {"brake-ignored", "the brake band is not looked at",
     [](Scene&, Ask& ask) {
       in<ClipAsk>(ask, [](ClipAsk& clip) { clip.brake = 1e300; });
       in<StepAsk>(ask, [](StepAsk& step) { step.brake = 1e300; });
     }},
    {"brake-across", "the brake band lies along y instead of x",
     [](Scene&, Ask& ask) {
       in<ClipAsk>(ask, [](ClipAsk& clip) {
         std::swap(clip.force_in_wheel[0], clip.force_in_wheel[1]);
         std::swap(clip.normal_in_wheel[0], clip.normal_in_wheel[1]);
       });
     }},
    {"force-limit-ignored", "the ground never gives way",
     [](Scene&, Ask& ask) { in_contact(ask, [](Contact& contact) { contact.maximum_force.reset(); }); }},
    {"relocation-ignored", "return mapping is taken for the spring relocation",
     [](Scene&, Ask& ask) {
       in<StepAsk>(ask, [](StepAsk& step) { step.wheel.relocation = Relocation::spring; });
     }},
    {"pebble-velocity-ignored", "the pebble is taken to be at rest",
     [](Scene&, Ask& ask) {
       in_contact(ask, [](Contact& contact) { contact.pebble_velocity_in_world = {}; });
     }},
    {"damping-ignored", "dampers are left out",
     [](Scene&, Ask& ask) { in<StepAsk>(ask, [](StepAsk& step) { step.wheel.d_xy = step.wheel.d_z = 0; }); }},
};

}  // namespace

std::span<const AskSlip> ask_slips() { return slips; }

}  // namespace groundtruth::diagnosis
