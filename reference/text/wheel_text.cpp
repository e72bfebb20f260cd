#include <groundtruth/text/wheel_text.hpp>

namespace groundtruth {
namespace {

Relocation read_relocation(const Field& field) {
  if (field.text() == "spring") return Relocation::spring;
  if (field.text() == "return-mapping") return Relocation::return_mapping;
  field.refuse_value("is neither \"spring\" nor \"return-mapping\"");
}

}  // namespace

Wheel read_wheel(const Field& field) {
  field.only(
      {"k_xy", "k_z", "d_xy", "d_z", "z_min", "z_zero", "z_max", "tyre", "min_uprightness", "relocation"});
  Wheel wheel;
  wheel.k_xy = field["k_xy"].negative();
  wheel.k_z = field["k_z"].negative();
  wheel.d_xy = field["d_xy"].at_most_zero();
  wheel.d_z = field["d_z"].at_most_zero();
  wheel.z_min = field["z_min"].number();
  wheel.z_zero = field["z_zero"].number();
  wheel.z_max = field["z_max"].number();
  if (!(wheel.z_min < wheel.z_zero)) field["z_min"].refuse_value("is not below z_zero");
  if (!(wheel.z_zero <= wheel.z_max)) field["z_zero"].refuse_value("is above z_max");
  wheel.tyre = field["tyre"].text();
  if (const auto uprightness = field.find("min_uprightness")) wheel.min_uprightness = uprightness->positive();
  if (const auto relocation = field.find("relocation")) wheel.relocation = read_relocation(*relocation);
  return wheel;
}

void write_wheel(JsonWriter& writer, const Wheel& wheel) {
  writer.open_object();
  writer.member("k_xy", wheel.k_xy);
  writer.member("k_z", wheel.k_z);
  writer.member("d_xy", wheel.d_xy);
  writer.member("d_z", wheel.d_z);
  writer.member("z_min", wheel.z_min);
  writer.member("z_zero", wheel.z_zero);
  writer.member("z_max", wheel.z_max);
  writer.member("tyre", wheel.tyre);
  writer.member("min_uprightness", wheel.min_uprightness);
  if (wheel.relocation == Relocation::return_mapping) writer.member("relocation", "return-mapping");
  writer.close_object();
}

Quaternion read_orientation(const Field& field) {
  field.require_size(4);
  Quaternion orientation{};
  for (std::size_t i = 0; i < 4; ++i) orientation[i] = field[i].number();
  if (orientation == Quaternion{0, 0, 0, 0}) field.refuse("[0, 0, 0, 0] is the zero quaternion");
  return orientation;
}

}  // namespace groundtruth
