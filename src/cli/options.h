// SPDX-License-Identifier: MIT
// Options that several commands share: the settings, the scene, and the view. Their variables must outlive the parsing.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "scene/acts.h"
#include "scene/read_scene.h"
#include "show/demo.h"

namespace ballpit {

/// Adds the settings of these names, or all if there are none, under a heading. Those on the command line are appended
/// to `given`, in the order of their table.
void add_settings(CommandOptions& command, const std::string& heading, std::vector<GivenOption>& given,
                  std::span<const std::string_view> names = {});

/// Warns of cells that are too small, and by formula of a run that cannot work.
void warn_of_run(Session& session);

/// SCENE and all settings.
struct SceneArguments {
  void add_to(CommandOptions& command);

  std::string scene{kDefaultScene};
  bool is_scene_given = false;
  std::vector<GivenOption> given{};
};

/// --acts: of a run that may be acted on.
struct ActsArgument {
  void add_to(CommandOptions& command);

  /// The acts of the file, checked against the session's scene at its start; none without the option.
  std::vector<Act> read(Session& session) const;

  std::string path{};
};

/// --lang, which sets the language of the program.
void add_language(CommandOptions& command);

/// --text-scale: of the scene's text.
void add_text_scale(CommandOptions& command, std::optional<float>& scale, float preset);

/// --overlay, --color, --theme, --occlusion, --caption, --turn, --compare, --ui-scale, --text-scale and --lang, for the
/// commands that draw. Those that were not given are empty.
struct LookArguments {
  void add_to(CommandOptions& command);

  /// What was not given is as in `base`.
  View view(View base) const;
  View view() const { return view(preset); }

  /// Throws UserError for options that do not go together, before a scene is loaded.
  void check(const SceneArguments& scene, PictureSize size) const;

  /// Sets the view of a new demonstration, and begins a comparison. Throws UserError if the scene cannot be shown so.
  void apply(Demo& demo, const View& base) const;

  View preset{};              ///< of the command
  float turn_of_default = 0;  ///< [°/s] in the scene that is shown if none is named
  std::optional<std::vector<std::string>> overlays{};
  std::optional<std::string> coloring{}, theme{}, occlusion{};
  std::optional<bool> has_caption{};
  std::vector<BroadPhase> compared{};
  std::optional<float> turn{}, ui_scale{}, text_scale{};
};

}  // namespace ballpit
