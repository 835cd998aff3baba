// SPDX-License-Identifier: MIT
#include "scene/catalog.h"

#include <filesystem>
#include <string>
#include <vector>

#include "core/embedded_file.h"
#include "core/error.h"
#include "scene/input_error.h"
#include "scene_files.h"

namespace ballpit {

std::span<const SceneInfo> built_in_scenes() {
  static const std::vector<SceneInfo> scenes = [] {
    std::vector<SceneInfo> result;
    for (const EmbeddedFile& file : scene_files()) result.push_back(parse_scene_info(file.text, file.name));
    return result;
  }();
  return scenes;
}

bool is_scene_file(std::string_view name_or_path) {
  return name_or_path.ends_with(".toml") || name_or_path.find('/') != std::string_view::npos;
}

Scene load_scene(std::string_view name_or_path, const SceneOverrides& overrides) {
  if (is_scene_file(name_or_path)) return read_scene(std::filesystem::path(name_or_path), overrides);
  for (const EmbeddedFile& file : scene_files()) {
    if (file.name == std::string(name_or_path) + ".toml") return parse_scene(file.text, file.name, {}, overrides);
  }
  std::vector<std::string> names;
  for (const SceneInfo& scene : built_in_scenes()) names.push_back(scene.name);
  throw UserError("SCENE", quoted(name_or_path), join(names) + ", or a path that ends in .toml or contains a '/'");
}

}  // namespace ballpit
