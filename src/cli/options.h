// SPDX-License-Identifier: MIT
// Options that several commands share: the settings, the scene, and the view.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "show/given_options.h"
#include "show/view.h"

namespace ballpit {

/// The settings as options of a command.
class SettingOptions {
 public:
  /// Adds the settings of these names, or all if there are none, under a heading. The object must outlive the parsing.
  void add_to(CommandOptions& command, const std::string& heading, std::span<const std::string_view> names = {});

  /// Those that were given, in the order of their table.
  const std::vector<GivenOption>& given() const { return given_; }

 private:
  std::vector<GivenOption> given_;
};

/// SCENE and all settings.
class SceneArguments {
 public:
  /// The object must outlive the parsing.
  void add_to(CommandOptions& command);

  const std::string& scene() const { return scene_; }
  bool names_scene() const { return names_scene_; }
  const std::vector<GivenOption>& given() const { return settings_.given(); }

 private:
  std::string scene_;
  bool names_scene_ = false;
  SettingOptions settings_;
};

/// --overlay, --color, --theme and --ui-scale, for the commands that draw.
class LookArguments {
 public:
  /// The object must outlive the parsing.
  void add_to(CommandOptions& command);

  /// The view that was asked for. What was not given is as in `base`.
  View view(View base = {}) const;

  bool names_overlays() const { return overlays_.has_value(); }
  bool scales_panel() const { return ui_scale_.has_value(); }

 private:
  std::optional<std::vector<std::string>> overlays_;
  std::optional<std::string> coloring_, theme_;
  std::optional<float> ui_scale_;
};

}  // namespace ballpit
