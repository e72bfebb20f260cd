#include "named_pack.hpp"

#include <groundtruth/cases/builtin_scenes.hpp>
#include <groundtruth/text/scene_text.hpp>

namespace groundtruth::cli {

NamedPack pack_named(const std::string& name) {
  if (const auto* builtin = cases::find_builtin_scene(name)) return {name, builtin->build()};
  return {name, {read_scene_file(name)}};
}

std::vector<NamedPack> packs_named(const std::vector<std::string>& names) {
  std::vector<NamedPack> packs;
  for (const std::string& name : names) packs.push_back(pack_named(name));
  if (!names.empty()) return packs;
  for (const auto& builtin : cases::builtin_scenes())
    packs.push_back({std::string(builtin.name), builtin.build()});
  return packs;
}

}  // namespace groundtruth::cli
