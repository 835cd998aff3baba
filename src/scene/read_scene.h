// SPDX-License-Identifier: MIT
// Reads a scene from TOML, checks it as far as possible before a run, and fills it with spheres.
//
// Order: parse; read each section (read_sections.h); read spheres from the list or the CSV file and check them; place the
// [[fill]] spheres around them (fill.h).
// Cost: O(n) for n spheres, and a sort by size.
// Every error is a UserError of one line: "a.toml:3: [physics] restitution: found 1.5, allowed 0 to 1".
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace ballpit {

/// Changes from the command line, made before the scene is filled.
struct SceneOverrides {
  std::optional<int64_t> count;      ///< spheres of all [[fill]] together, distributed in proportion
  std::optional<uint64_t> seed;      ///< of the random spheres; else `seed` of [defaults], else 1
  std::optional<double> mass_ratio;  ///< of heavy and light listed spheres; see mass_ratio.h
};

/// Reads the scene in the file `path`. The path of its CSV file is relative to it.
Scene read_scene(const std::filesystem::path& path, const SceneOverrides& overrides = {});

/// Reads a scene from its text. `file_name` is for errors, `folder` for the path of a CSV file.
Scene parse_scene(std::string_view text, std::string_view file_name, const std::filesystem::path& folder = {},
                  const SceneOverrides& overrides = {});

/// Reads only name, title and description.
SceneInfo parse_scene_info(std::string_view text, std::string_view file_name);

/// The scenes in assets/scenes/, which are compiled into the program, the default scene first.
std::span<const SceneInfo> built_in_scenes();

/// The scene that runs if none is named.
inline constexpr std::string_view kDefaultScene = "bouncing-balls";

/// Whether a scene is given as a file, not by its name: a path ends in .toml or contains a '/'.
bool is_scene_file(std::string_view name_or_path);

/// A built-in scene by name, or the scene in a file. Throws UserError that lists the names if there is no such scene.
Scene load_scene(std::string_view name_or_path, const SceneOverrides& overrides = {});

}  // namespace ballpit
