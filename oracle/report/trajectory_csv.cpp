#include <groundtruth/report/trajectory_csv.hpp>

#include <fmt/format.h>

namespace groundtruth::report {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

std::string cells(const Eigen::Vector3d& v) { return fmt::format(",{},{},{}", v.x(), v.y(), v.z()); }

const char* state_of(const WheelState& wheel) {
  const auto* contact = std::get_if<Contact>(&wheel);
  if (contact == nullptr) return "free";
  return contact->grip == Grip::stick ? "stick" : "slip";
}

}  // namespace

void write_csv_header(std::ostream& out, std::size_t wheels) {
  out << "time";
  const auto vector = [&](const std::string& name) {
    for (const char* axis : axes) out << fmt::format(",{}_{}", name, axis);
  };
  vector("position");
  vector("velocity");
  out << ",orientation_w";
  vector("orientation");
  vector("angular_velocity");
  out << ",energy";
  for (std::size_t i = 0; i < wheels; ++i) {
    out << fmt::format(",wheel{}_state", i);
    vector(fmt::format("wheel{}_pebble", i));
    vector(fmt::format("wheel{}_force", i));
  }
  out << "\n";
}

void write_csv_row(std::ostream& out, const rig::Moment& moment) {
  const rig::BodyState& body = moment.state.body;
  out << fmt::format("{}", moment.time) << cells(body.position_in_world) << cells(body.velocity_in_world)
      << fmt::format(",{}", body.world_from_body.w()) << cells(body.world_from_body.vec())
      << cells(body.angular_velocity_in_world) << fmt::format(",{}", moment.energy);
  for (std::size_t i = 0; i < moment.state.wheels.size(); ++i) {
    const WheelState& wheel = moment.state.wheels[i];
    out << "," << state_of(wheel);
    if (const auto* contact = std::get_if<Contact>(&wheel)) {
      const Vector& p = contact->pebble_in_world;
      out << cells({p[0], p[1], p[2]});
    } else {
      out << ",,,";
    }
    out << cells(moment.record.forces_in_world[i]);
  }
  out << "\n";
}

}  // namespace groundtruth::report
