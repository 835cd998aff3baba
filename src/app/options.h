// SPDX-License-Identifier: MIT
// What the commands' options share: the table of settings as CLI11 options, and parsers that name the option,
// what was found and what is allowed.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/command_line.h"
#include "app/given_options.h"
#include "app/view.h"
#include "core/error.h"

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

/// An integer in [low, high]. Throws UserError naming the option.
int64_t parse_integer(std::string_view option, const std::string& text, int64_t low, int64_t high);

/// A number in [low, high]. Throws UserError naming the option.
double parse_number(std::string_view option, const std::string& text, double low, double high);

/// One of `choices`. Throws UserError naming the option.
const std::string& parse_choice(std::string_view option, const std::string& text,
                                const std::vector<std::string>& choices);

/// The items of a list "a,b,c"; an empty one is an item, too.
std::vector<std::string> split_list(const std::string& text);

/// Names of overlays, "a,b,c", or "none". Throws UserError naming the option.
std::vector<std::string> parse_overlays(std::string_view option, const std::string& text);

/// A path that is not empty. Throws UserError naming the option.
const std::string& parse_path(std::string_view option, const std::string& text);

/// The path of an output, looked at before any work is done. Throws UserError where it is empty, RunError where it cannot be
/// written.
const std::string& parse_output(std::string_view option, const std::string& text);

/// Throws UserError where an output leads to the same place as a file that `name` is given.
void reject_same_file(std::string_view option, const std::string& path, std::string_view name,
                      const std::string& other);

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

struct PictureSize {
  int width;
  int height;
};

/// "1280x720". Throws UserError.
PictureSize parse_size(const std::string& text);

}  // namespace ballpit
