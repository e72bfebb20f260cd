#pragma once
// What happens in a step (SPEC section 5), without its numbers. Not installed.

#include <groundtruth/fast/step_contact.hpp>
#include <groundtruth/fast/step_load.hpp>
#include <groundtruth/fast/step_strut.hpp>

namespace groundtruth::fast {

// The surface that the pebble comes to lie on, and its plane.
struct Contacted {
  Surface surface;
  HalfSpace plane;
};

// What the strut finds: nothing, or its end; a reason not to go on; or a surface.
using Touch = std::variant<NoContact, StepFailure, Refusal, Contacted>;

struct StepPlan {
  Touch touch;                         // of a free wheel or a slip; NoContact or a failure else
  Clipping clipping = Clipping::none;  // of a wheel in contact
  bool bears_force = false;            // a wheel in contact that the ground presses, and that holds
};

// All decisions of a step, in counted numbers; nothing where one is uncertain.
template <class Real>
class StepPlanner {
 public:
  StepPlanner(const Scene& scene, const StepAsk& ask) : scene_(scene), ask_(ask) {}

  std::optional<StepPlan> plan() const {
    const auto* contact = std::get_if<Contact>(&ask_.state);
    return contact ? from(*contact) : from_free();
  }

 private:
  std::optional<StepPlan> from_free() const {
    const WheelAxes<Real> axes(ask_.frame.world_from_wheel);
    auto touch = touch_at(axes, CountedVector<Real, 0>{});
    if (!touch) return std::nullopt;
    return StepPlan{std::move(*touch), Clipping::none, false};
  }

  std::optional<StepPlan> from(const Contact& contact) const {
    const Load<Real> load(ask_, contact);
    const auto& unit = load.axes().norm_squared();
    const auto extended = is_at_most(unit * counted<Real>(ask_.wheel.z_max), load.depth());
    if (!extended) return std::nullopt;
    if (*extended) return StepPlan{NoContact{}};
    const auto compressed = is_at_most(load.depth(), unit * counted<Real>(ask_.wheel.z_min));
    if (!compressed) return std::nullopt;
    if (*compressed) return StepPlan{StepFailure::wheel_broken};
    const auto upright = is_upright_in_wheel(load.axes(), contact.normal_in_world);
    if (!upright) return std::nullopt;
    if (!*upright) return StepPlan{StepFailure::surface_too_steep};
    return under(load);
  }

  std::optional<StepPlan> under(const Load<Real>& load) const {
    const auto grasp = load.grasp();
    const auto velocity = load.velocity();
    const auto force = load.force(velocity);
    const auto forward = load.forward();
    const ForceOnSurface on_surface(grasp, forward, force);
    const Sign pressed = sign_of(on_surface.down());
    if (pressed == Sign::uncertain) return std::nullopt;
    if (pressed != Sign::positive) return StepPlan{NoContact{}};
    if (const auto& limit = load.contact().maximum_force) {
      const auto holds =
          is_at_most(square(on_surface.down()), square(counted<Real>(*limit)) * on_surface.n_squared());
      if (!holds) return std::nullopt;
      if (!*holds) return StepPlan{StepFailure::surface_gave_way};
    }
    const auto clipping = on_surface.decide();
    if (!clipping) return std::nullopt;
    if (*clipping == Clipping::none) return StepPlan{NoContact{}, *clipping, true};
    auto touch = on_surface.clipped(*clipping, [&](const auto& clipped) {
      return touch_at(load.axes(), load.relocated(clipped, velocity));
    });
    if (!touch) return std::nullopt;
    return StepPlan{std::move(*touch), *clipping, true};
  }

  template <int n>
  std::optional<Touch> touch_at(const WheelAxes<Real>& axes, const CountedVector<Real, n>& offset) const {
    const auto found = face_along(scene_, CountedStrut(ask_, axes, offset).ends());
    if (!found) return std::nullopt;
    if (std::holds_alternative<NoContact>(*found)) return NoContact{};
    if (const auto* failure = std::get_if<StepFailure>(&*found)) return *failure;
    const auto& face = std::get<FaceFound>(*found);
    const HalfSpace& plane = face.plane;
    const auto upright = is_upright_in_wheel(axes, plane.normal);
    if (!upright) return std::nullopt;
    if (!*upright) return StepFailure::surface_too_steep;
    const auto surface = surface_of(scene_, face.leaf, plane.normal, face.material, ask_.wheel.tyre);
    if (const auto* refusal = std::get_if<Refusal>(&surface)) return *refusal;
    return Contacted{std::get<Surface>(surface), plane};
  }

  std::optional<bool> is_upright_in_wheel(const WheelAxes<Real>& axes, const Vector& normal_in_world) const {
    const auto normal = counted<Real>(normal_in_world);
    const auto& unit = axes.norm_squared();
    return is_upright(dot(axes.down(), normal), dot(normal, normal) * (unit * unit),
                      ask_.wheel.min_uprightness);
  }

  const Scene& scene_;
  const StepAsk& ask_;
};

}  // namespace groundtruth::fast
