#include <groundtruth/cases/ground_materials.hpp>

namespace groundtruth::cases {

std::vector<Material> ground_materials() {
  return {
      {"dry", {{"rubber", {0.4, 0.4}}, {"metal", {0.3, 0.25}}}, 1e7},
      {"wet", {{"rubber", {0.1, 0.1}}, {"metal", {0.25, 0.2}}}, 1e7},
      {"icy", {{"rubber", {0.001, 0.001}}, {"metal", {0.01, 0.005}}}, 50000.0},
      {"dirty", {{"rubber", {0.3, 0.3}}, {"metal", {0.5, 0.375}}}, 20000.0},
      {"water", {{"rubber", {0, 0}}, {"metal", {0, 0}}}, 0.0},
      {"glass", {{"metal", {0.125, 0.0625}}}, {}},
  };
}

}  // namespace groundtruth::cases
