#include <groundtruth/text/scene_reader.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <unordered_map>

#include <groundtruth/text/scene_text.hpp>

namespace groundtruth {
namespace {

using MaterialIndices = std::unordered_map<std::string, MaterialIndex>;

Friction read_friction(const Field& field) {
  field.only({"static", "dynamic"});
  return {field["static"].at_least_zero(), field["dynamic"].at_least_zero()};
}

Material read_material(const std::string& name, const Field& field) {
  field.only({"friction", "max_force"});
  Material material{name, {}, {}};
  const auto friction = field.find("friction");
  const std::size_t tyres = friction ? friction->object().size() : 0;
  for (std::size_t i = 0; i < tyres; ++i) {
    material.friction_by_tyre[friction->object()[i].first] = read_friction(friction->member(i));
  }
  const auto maximum = field.find("max_force");
  if (maximum && !maximum->is_null()) material.maximum_force = maximum->at_least_zero();
  return material;
}

class ShapeReader {
 public:
  explicit ShapeReader(const MaterialIndices& indices) : indices_(indices) {}

  // `depth` counts the shapes that this one is in.
  Shape read(const Field& field, std::size_t depth = 0) const {
    if (depth == maximum_shape_depth) {
      field.refuse("shapes are nested deeper than " + std::to_string(maximum_shape_depth));
    }
    if (field.is_text()) return read_constant(field);
    if (field.object().empty()) field.refuse("an empty object is no shape");
    if (field.find("material")) return read_covered(field, depth + 1);
    if (field.find("paint")) return read_painted(field, depth + 1);
    if (field.object().size() != 1) {
      field.refuse(
          "a shape has one key: halfspace, box, union, intersection; or material, shape; or paint, where, "
          "shape");
    }
    return read_operator(field, field.object().front().first, depth + 1);
  }

 private:
  static Shape read_constant(const Field& field) {
    if (field.text() == "everything") return {Everything{}};
    if (field.text() == "nothing") return {Nothing{}};
    field.refuse_value("is no shape");
  }

  Shape read_operator(const Field& field, const std::string& key, std::size_t depth) const {
    if (key == "halfspace") return read_half_space(field[key]);
    if (key == "box") return read_box(field[key]);
    if (key == "union") return {Union{read_operands(field[key], depth)}};
    if (key == "intersection") return {Intersection{read_operands(field[key], depth)}};
    field.member(0).refuse("unknown key");
  }

  static Shape read_half_space(const Field& field) {
    field.require_size(4);
    return {HalfSpace{{field[0].number(), field[1].number(), field[2].number()}, field[3].number()}};
  }

  static Shape read_box(const Field& field) {
    field.require_size(2);
    const Vector low = field[0].vector();
    const Vector high = field[1].vector();
    Intersection box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      HalfSpace below{{}, 0.0 - low[axis]};
      below.normal[axis] = -1;
      HalfSpace above{{}, high[axis]};
      above.normal[axis] = 1;
      box.operands.push_back({below});
      box.operands.push_back({above});
    }
    return {std::move(box)};
  }

  std::vector<Shape> read_operands(const Field& field, std::size_t depth) const {
    std::vector<Shape> operands;
    operands.reserve(field.size());
    for (std::size_t i = 0; i < field.size(); ++i) operands.push_back(read(field[i], depth));
    return operands;
  }

  std::shared_ptr<const Shape> read_shared(const Field& field, std::size_t depth) const {
    return std::make_shared<const Shape>(read(field, depth));
  }

  Shape read_covered(const Field& field, std::size_t depth) const {
    field.only({"material", "shape"});
    return {Covered{read_material_name(field["material"]), read_shared(field["shape"], depth)}};
  }

  Shape read_painted(const Field& field, std::size_t depth) const {
    field.only({"paint", "where", "shape"});
    return {Painted{read_material_name(field["paint"]), read_shared(field["where"], depth),
                    read_shared(field["shape"], depth)}};
  }

  MaterialIndex read_material_name(const Field& field) const {
    const auto found = indices_.find(field.text());
    if (found == indices_.end()) field.refuse_value("is not in materials");
    return found->second;
  }

  const MaterialIndices& indices_;
};

}  // namespace

Scene read_scene(const Field& field) {
  field.only({"groundtruth", "materials", "shape"});
  if (field["groundtruth"].text() != "scene/1") field["groundtruth"].refuse_value("is not \"scene/1\"");
  Scene scene;
  MaterialIndices indices;
  const auto materials = field.find("materials");
  const std::size_t count = materials ? materials->object().size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& name = materials->object()[i].first;
    scene.materials.push_back(read_material(name, materials->member(i)));
    indices.emplace(name, i);
  }
  const ShapeReader reader(indices);
  scene.shape = reader.read(field["shape"]);
  return scene;
}

Scene read_scene(std::string_view text, const Origin& origin) {
  const Json json = parse_json(text, origin);
  return read_scene(Field(json, origin));
}

Scene read_scene_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) throw BadInput(file, 0, "", "cannot be read");
  std::ostringstream text;
  text << stream.rdbuf();
  return read_scene(text.str(), {file, 1});
}

}  // namespace groundtruth
