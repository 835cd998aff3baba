// SPDX-License-Identifier: MIT
// What the commands' options share: the table of settings as options, the scene, and how it is looked at.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "core/error.h"
#include "show/given_options.h"
#include "show/parse.h"
#include "show/view.h"

namespace ballpit {

/// Options of the shared table, on the command line of a command.
class SettingOptions {
 public:
  /// Adds those of these names, or all where none is named, under a heading. The object must outlive the parsing.
  void add_to(CommandOptions& command, const std::string& heading, std::span<const std::string_view> names = {});

  /// Those that were given, in the order of their table.
  std::vector<GivenOption> given() const;

 private:
  std::map<std::string, std::string, std::less<>> values_;  // as typed; absent options are empty
  std::vector<std::pair<std::string, CommandOption*>> options_;
};

/// The arguments that every simulating command takes: SCENE and the shared options.
class SceneArguments {
 public:
  /// Adds them to a command. The object must outlive the parsing.
  void add_to(CommandOptions& command);

  const std::string& scene() const { return scene_; }
  bool names_scene() const { return option_->is_given(); }
  std::vector<GivenOption> given() const { return settings_.given(); }

 private:
  std::string scene_;
  CommandOption* option_ = nullptr;
  SettingOptions settings_;
};

/// How a scene is looked at, for the commands that draw: --overlay, --color, --theme, --ui-scale.
class LookArguments {
 public:
  /// Adds them to a command. The object must outlive the parsing.
  void add_to(CommandOptions& command);

  /// Throws UserError naming the option. What was not given is as in `base`.
  View view(const View& base = {}) const;

  bool asks_for_overlays() const { return options_.at("--overlay")->is_given(); }
  bool scales_panel() const { return options_.at("--ui-scale")->is_given(); }

 private:
  View default_;
  std::map<std::string, CommandOption*> options_;
  std::string overlays_ = join(default_.overlays, ","), coloring_ = default_.coloring, theme_ = default_.theme,
              ui_scale_ = "1";
};

}  // namespace ballpit
