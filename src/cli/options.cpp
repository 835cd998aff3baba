// SPDX-License-Identifier: MIT
#include "cli/options.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/theme.h"
#include "scene/read_scene.h"

namespace ballpit {

void SettingOptions::add_to(CommandOptions& command, const std::string& heading,
                            std::span<const std::string_view> names) {
  for (const SettingInfo& setting : setting_table()) {
    if (!names.empty() && std::find(names.begin(), names.end(), setting.name) == names.end()) continue;
    command.add({.name = "--" + std::string(setting.name),
                 .type = std::string(setting.value_name),
                 .help = fmt::format("{}: {}{}", setting.help, setting.allowed,
                                     names.empty() ? "; default: " + setting.preset : ""),
                 .group = heading},
                [this, &setting](const std::string& text) {
                  given_.push_back({std::string(setting.name), text});
                });
  }
}

void SceneArguments::add_to(CommandOptions& command) {
  scene_ = kDefaultScene;
  command.add({"SCENE", "", "a built-in scene (see `ballpit list`) or a .toml file", scene_},
              [this](const std::string& text) {
                scene_ = text;
                names_scene_ = true;
              });
  settings_.add_to(command, "Simulation (the scene may have other defaults)");
}

void LookArguments::add_to(CommandOptions& command) {
  const View preset;
  const auto add_name = [&](const char* name, const std::string& help, const std::vector<std::string>& names,
                            const std::string& shown, std::optional<std::string>& chosen) {
    command.add({name, "NAME", help + join(names), shown},
                [&chosen, name, names](const std::string& text) { chosen = parse_choice(name, text, names); });
  };
  command.add(
      {"--overlay", "A,B,…", "what to draw over the spheres: none, or some of " + join(names_in(overlay_table())),
       join(preset.overlays, ",")},
      [this](const std::string& text) { overlays_ = parse_overlays("--overlay", text); });
  add_name("--color", "what a sphere's colour shows: ", names_in(coloring_table()), preset.coloring, coloring_);
  add_name("--theme", "", names_in(themes()), preset.theme, theme_);
  command.add_number({"--ui-scale", "FACTOR", "size of the panel's text and widgets", typed(preset.ui_scale)},
                     ui_scale_, Range{kMinUiScale, kMaxUiScale});
}

View LookArguments::view(View base) const {
  base.overlays = overlays_.value_or(base.overlays);
  base.coloring = coloring_.value_or(base.coloring);
  base.theme = theme_.value_or(base.theme);
  base.ui_scale = ui_scale_.value_or(base.ui_scale);
  return base;
}

}  // namespace ballpit
