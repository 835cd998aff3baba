// SPDX-License-Identifier: MIT
// Reads a scene from TOML, checks everything that can be checked before a run, and fills it with spheres.
//
// The order of work: parse; read each section (read_sections.h); take spheres from the list or the CSV file
// and check them (check_spheres.h); place the [[fill]] spheres around them (fill.h).
// Cost: O(n) for n spheres, beside a sort by size.
// Every error is a UserError of one line: "a.toml:3: [physics] restitution: found 1.5, allowed 0 to 1".
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace ballpit {

/// What the command line changes in a scene before it is filled.
struct SceneOverrides {
  std::optional<int64_t> count;  ///< spheres of all [[fill]] together; several are scaled in proportion
  std::optional<uint64_t> seed;  ///< of what is random; else `seed` of [defaults], else 1
};

/// What a list of scenes shows of one.
struct SceneInfo {
  std::string name;  ///< "bouncing-balls"
  std::string title;
  std::string description;
  std::string title_de;
  std::string description_de;
};

/// Reads the scene in the file `path`; a CSV file that it names is looked up beside it.
Scene read_scene(const std::filesystem::path& path, const SceneOverrides& overrides = {});

/// Reads a scene from its text. `file_name` is what errors call it, `folder` where a CSV file would lie.
Scene parse_scene(std::string_view text, std::string_view file_name, const std::filesystem::path& folder = {},
                  const SceneOverrides& overrides = {});

/// Reads only name, title and description.
SceneInfo parse_scene_info(std::string_view text, std::string_view file_name);

}  // namespace ballpit
