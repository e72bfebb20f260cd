#include <groundtruth/text/json_writer.hpp>
#include <groundtruth/text/scene_text.hpp>

namespace groundtruth {
namespace {

class ShapeWriter {
 public:
  ShapeWriter(JsonWriter& writer, const std::vector<Material>& materials)
      : writer_(writer), materials_(materials) {}

  void write(const Shape& shape) {
    std::visit([this](const auto& expression) { (*this)(expression); }, shape.expression);
  }

  void operator()(const Everything&) { writer_.text("everything"); }
  void operator()(const Nothing&) { writer_.text("nothing"); }
  void operator()(const HalfSpace& half_space) {
    const auto& [x, y, z] = half_space.normal;
    writer_.open_object();
    writer_.member("halfspace", std::array<double, 4>{x, y, z, half_space.offset});
    writer_.close_object();
  }
  void operator()(const Union& united) { write_operator("union", united.operands); }
  void operator()(const Intersection& intersected) { write_operator("intersection", intersected.operands); }
  void operator()(const Covered& covered) {
    writer_.open_object();
    writer_.member("material", materials_[covered.material].name);
    write_member("shape", *covered.over);
    writer_.close_object();
  }
  void operator()(const Painted& painted) {
    writer_.open_object();
    writer_.member("paint", materials_[painted.material].name);
    write_member("where", *painted.where);
    write_member("shape", *painted.over);
    writer_.close_object();
  }

 private:
  void write_operator(const char* name, const std::vector<Shape>& operands) {
    writer_.open_object();
    writer_.key(name);
    writer_.open_array();
    for (const Shape& operand : operands) write(operand);
    writer_.close_array();
    writer_.close_object();
  }

  void write_member(const char* name, const Shape& shape) {
    writer_.key(name);
    write(shape);
  }

  JsonWriter& writer_;
  const std::vector<Material>& materials_;
};

void write_material(JsonWriter& writer, const Material& material) {
  writer.key(material.name);
  writer.open_object();
  writer.key("friction");
  writer.open_object();
  for (const auto& [tyre, friction] : material.friction_by_tyre) {
    writer.key(tyre);
    writer.open_object();
    writer.member("static", friction.static_coefficient);
    writer.member("dynamic", friction.dynamic_coefficient);
    writer.close_object();
  }
  writer.close_object();
  if (material.maximum_force) writer.member("max_force", *material.maximum_force);
  writer.close_object();
}

}  // namespace

std::string write_scene(const Scene& scene) {
  JsonWriter writer;
  writer.open_object();
  writer.member("groundtruth", "scene/1");
  writer.key("materials");
  writer.open_object();
  for (const Material& material : scene.materials) write_material(writer, material);
  writer.close_object();
  writer.key("shape");
  ShapeWriter(writer, scene.materials).write(scene.shape);
  writer.close_object();
  return writer.take();
}

}  // namespace groundtruth
