#include <groundtruth/definition/prepared_scene.hpp>
#include <groundtruth/definition/scene.hpp>

namespace groundtruth::definition {

Scene::Scene(const groundtruth::Scene& scene)
    : prepared_(
          std::make_shared<const PreparedScene>(PreparedScene{scene.materials, expression_of(scene.shape)})) {
}

}  // namespace groundtruth::definition
