#include <groundtruth/fast/step.hpp>

#include <Eigen/Geometry>
#include <groundtruth/fast/entry.hpp>
#include <groundtruth/fast/material.hpp>
#include <groundtruth/fast/rotation.hpp>
#include <groundtruth/fast/surface.hpp>

namespace groundtruth::fast {

namespace {

// Within these, no product that a step forms in doubles overflows.
constexpr Magnitudes ordinary_step_size{0x1p-100, 0x1p60};

struct NoContact {};

template <class Number>
struct Landing {
  Vector3<Number> pebble_in_world;
  Vector normal_in_world;
  Friction friction;
  std::optional<double> maximum_force;

  Contact contact(Grip grip, const Vector3<Number>& velocity_in_world) const {
    return {grip,
            rounded(pebble_in_world),
            rounded(velocity_in_world),
            normal_in_world,
            friction.static_coefficient,
            friction.dynamic_coefficient,
            maximum_force};
  }
};

template <class Number>
using Touch = std::variant<NoContact, Landing<Number>, StepFailure, Refusal>;

std::variant<const Material*, Refusal> material_for(const Scene& scene, Leaf leaf,
                                                    std::optional<MaterialIndex> material,
                                                    const std::string& tyre) {
  const auto refusal = [&](const std::string& why) {
    return Refusal{"contact: leaf " + std::to_string(leaf) + why};
  };
  if (!material) return refusal(" has no material");
  const Material& found = scene.materials()[*material];
  if (found.friction_by_tyre.count(tyre) == 0)
    return refusal(": material '" + found.name + "' has no friction for '" + tyre + "'");
  return &found;
}

StepAnswer answer_with(const Contact& contact, const Vector& force_on_frame_in_world) {
  if (auto refusal = refuse_unless_finite(contact.pebble_in_world, "state.pebble")) return *refusal;
  if (auto refusal = refuse_unless_finite(contact.pebble_velocity_in_world, "state.velocity"))
    return *refusal;
  if (auto refusal = refuse_unless_finite(force_on_frame_in_world, "force")) return *refusal;
  return Stepped{contact, force_on_frame_in_world};
}

StepAnswer answer_with(const Free& free, const Vector& force_on_frame_in_world) {
  if (auto refusal = refuse_unless_finite(force_on_frame_in_world, "force")) return *refusal;
  return Stepped{free, force_on_frame_in_world};
}

template <class Number>
class Stepper {
 public:
  Stepper(const Scene& scene, const StepAsk& ask)
      : scene_(scene),
        ask_(ask),
        world_from_wheel_(ask.frame.world_from_wheel),
        frame_in_world_(as<Number>(ask.frame.position_in_world)) {}

  StepAnswer from_free() const {
    const Touch<Number> touch = land(0, 0);
    if (const auto* landing = std::get_if<Landing<Number>>(&touch))
      return answer_with(landing->contact(Grip::stick, Vector3<Number>::Zero()), Vector{});
    return no_landing(touch, Vector{});
  }

  StepAnswer from(const Contact& contact) const {
    const Wheel& wheel = ask_.wheel;
    const Vector3<Number> arm_in_world = as<Number>(contact.pebble_in_world) - frame_in_world_;
    const Vector3<Number> p = world_from_wheel_.to_wheel(arm_in_world);
    const Vector3<Number> w = pebble_velocity_in_wheel(contact, arm_in_world);
    const Vector3<Number> n = world_from_wheel_.direction_to_wheel(as<Number>(contact.normal_in_world));
    if (p.z() >= wheel.z_max) return Stepped{Free{}, Vector{}};
    if (p.z() <= wheel.z_min) return StepFailure::wheel_broken;
    if (!is_upright<Number>(n, wheel.min_uprightness)) return StepFailure::surface_too_steep;

    const Vector3<Number> force = spring_force(p, w);
    const Number pressing = -n.dot(force);  // F'_z |n|
    if (pressing <= 0) return Stepped{Free{}, Vector{}};
    if (contact.maximum_force) {
      const Number limit(*contact.maximum_force);
      if (pressing * pressing > limit * limit * n.squaredNorm()) return StepFailure::surface_gave_way;
    }
    const double friction = contact.grip == Grip::stick ? contact.static_friction : contact.dynamic_friction;
    const auto clipped = clip_force(Grasp<Number>{n, Number(friction), Number(ask_.brake)}, force);
    const Vector force_on_frame = rounded<Number>(-world_from_wheel_.to_world(clipped.force_in_wheel));
    if (clipped.grip == Grip::slip) return slip(contact, p, w, clipped.force_in_wheel, force_on_frame);
    Contact stuck = contact;
    stuck.grip = Grip::stick;
    stuck.pebble_velocity_in_world = Vector{};
    return answer_with(stuck, force_on_frame);
  }

 private:
  Vector3<Number> pebble_velocity_in_wheel(const Contact& contact,
                                           const Vector3<Number>& arm_in_world) const {
    const Vector3<Number> turning = as<Number>(ask_.frame.angular_velocity_in_world).cross(arm_in_world);
    return world_from_wheel_.to_wheel(as<Number>(contact.pebble_velocity_in_world) -
                                      as<Number>(ask_.frame.velocity_in_world) - turning);
  }

  // On the pebble, in wheel coordinates.
  Vector3<Number> spring_force(const Vector3<Number>& p, const Vector3<Number>& w) const {
    const Wheel& wheel = ask_.wheel;
    const Number k_xy(wheel.k_xy), k_z(wheel.k_z), d_xy(wheel.d_xy), d_z(wheel.d_z), z_zero(wheel.z_zero);
    return {k_xy * p.x() + d_xy * w.x(), k_xy * p.y() + d_xy * w.y(), k_z * (p.z() - z_zero) + d_z * w.z()};
  }

  StepAnswer slip(const Contact& contact, const Vector3<Number>& p, const Vector3<Number>& w,
                  const Vector3<Number>& clipped_force, const Vector& force_on_frame) const {
    const auto relocated = [&](int axis) {
      const Number k_xy(ask_.wheel.k_xy);
      if (ask_.wheel.relocation == Relocation::spring) return clipped_force[axis] / k_xy;
      const Number d_xy(ask_.wheel.d_xy), damping = d_xy / Number(ask_.h);
      return (clipped_force[axis] + damping * p[axis] - d_xy * w[axis]) / (k_xy + damping);
    };
    const Touch<Number> touch = land(relocated(0), relocated(1));
    const auto* landing = std::get_if<Landing<Number>>(&touch);
    if (!landing) return no_landing(touch, force_on_frame);
    const Vector3<Number> velocity =
        (landing->pebble_in_world - as<Number>(contact.pebble_in_world)) / Number(ask_.h);
    return answer_with(landing->contact(Grip::slip, velocity), force_on_frame);
  }

  static StepAnswer no_landing(const Touch<Number>& touch, const Vector& force_on_frame) {
    if (const auto* failure = std::get_if<StepFailure>(&touch)) return *failure;
    if (const auto* refusal = std::get_if<Refusal>(&touch)) return *refusal;
    return answer_with(Free{}, force_on_frame);
  }

  Vector3<Number> in_world(Number x, Number y, Number z) const {
    return frame_in_world_ + world_from_wheel_.to_world({x, y, z});
  }

  // Where the wheel at (x, y) in its own coordinates touches the ground.
  Touch<Number> land(Number x, Number y) const {
    const Number z_min(ask_.wheel.z_min), z_max(ask_.wheel.z_max);
    const Segment<Number> segment(in_world(x, y, z_min), in_world(x, y, z_max));
    const auto entry = find_entry<Number>(scene_, segment, {0, 1});
    if (!entry || entry->lambda == 1) return NoContact{};
    if (entry->lambda == 0 || !entry->leaf) return StepFailure::wheel_broken;
    const Vector& normal = scene_.solid().leaves[*entry->leaf].normal;
    const Vector3<Number> normal_in_wheel = world_from_wheel_.direction_to_wheel(as<Number>(normal));
    if (!is_upright<Number>(normal_in_wheel, ask_.wheel.min_uprightness))
      return StepFailure::surface_too_steep;
    const auto found = material_for(
        scene_, *entry->leaf, material_at(scene_, *entry->leaf, segment, entry->lambda), ask_.wheel.tyre);
    if (const auto* refusal = std::get_if<Refusal>(&found)) return *refusal;
    const Material& material = *std::get<const Material*>(found);
    return Landing<Number>{in_world(x, y, z_min + entry->lambda * (z_max - z_min)), normal,
                           material.friction_by_tyre.find(ask_.wheel.tyre)->second, material.maximum_force};
  }

  const Scene& scene_;
  const StepAsk& ask_;
  const WorldFromWheel<Number> world_from_wheel_;
  const Vector3<Number> frame_in_world_;
};

bool is_ordinary(const Contact& contact) {
  const Magnitudes& size = ordinary_step_size;
  return size.contains(contact.pebble_in_world) && size.contains(contact.pebble_velocity_in_world) &&
         size.contains(contact.normal_in_world) && size.contains(contact.maximum_force.value_or(0));
}

bool is_ordinary(const StepAsk& ask) {
  const Magnitudes& size = ordinary_step_size;
  const Wheel& wheel = ask.wheel;
  const Frame& frame = ask.frame;
  for (const double x : {wheel.k_xy, wheel.k_z, wheel.d_xy, wheel.d_z, wheel.z_min, wheel.z_zero, wheel.z_max,
                         wheel.min_uprightness, ask.h})
    if (!size.contains(x)) return false;
  for (const double component : frame.world_from_wheel)
    if (!size.contains(component)) return false;
  return size.contains(frame.position_in_world) && size.contains(frame.velocity_in_world) &&
         size.contains(frame.angular_velocity_in_world);
}

template <class Number>
StepAnswer answer(const Scene& scene, const StepAsk& ask) {
  const Stepper<Number> stepper(scene, ask);
  const auto* contact = std::get_if<Contact>(&ask.state);
  return contact ? stepper.from(*contact) : stepper.from_free();
}

}  // namespace

StepAnswer step(const Scene& scene, const StepAsk& ask) {
  const auto* contact = std::get_if<Contact>(&ask.state);
  const bool is_all_ordinary =
      scene.is_of_ordinary_size() && is_ordinary(ask) && (!contact || is_ordinary(*contact));
  return is_all_ordinary ? answer<double>(scene, ask) : answer<Wide>(scene, ask);
}

}  // namespace groundtruth::fast
