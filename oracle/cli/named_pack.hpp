#pragma once
// Scenes as the command line names them: a built-in name, or a file.

#include <string>
#include <vector>

#include <groundtruth/problem/scene.hpp>

namespace groundtruth::cli {

struct NamedPack {
  std::string name;
  std::vector<Scene> pack;
};

// Throws what read_scene_file() throws.
NamedPack pack_named(const std::string& name);

// Those of these names; without names, all built-in ones.
std::vector<NamedPack> packs_named(const std::vector<std::string>& names);

}  // namespace groundtruth::cli
