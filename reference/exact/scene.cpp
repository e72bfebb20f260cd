#include <groundtruth/exact/scene.hpp>

#include <groundtruth/exact/solid/solid.hpp>

namespace groundtruth::exact {

Scene::Scene(const groundtruth::Scene& scene) : ground_(std::make_shared<const Ground>(lay_out(scene))) {}

}  // namespace groundtruth::exact
