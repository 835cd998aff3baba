// SPDX-License-Identifier: MIT
// The built-in scenes: assets/scenes/*.toml, compiled into the program so that it needs no files.
#pragma once

#include <span>
#include <string_view>

#include "scene/read_scene.h"
#include "scene/scene.h"

namespace ballpit {

/// The built-in scenes, the default scene first.
std::span<const SceneInfo> built_in_scenes();

/// The scene that runs if none is named.
inline constexpr std::string_view kDefaultScene = "bouncing-balls";

/// Whether a scene is given as a file, not by its name.
bool is_scene_file(std::string_view name_or_path);

/// A built-in scene by name, or the scene in a file: a path ends in .toml or contains a '/'. Throws UserError that lists the
/// names if there is no such scene.
Scene load_scene(std::string_view name_or_path, const SceneOverrides& overrides = {});

}  // namespace ballpit
