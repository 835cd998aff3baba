// SPDX-License-Identifier: MIT
#include "cli/options.h"

#include <algorithm>

#include "render/coloring.h"
#include "render/overlays/overlay.h"
#include "render/theme.h"
#include "scene/catalog.h"

namespace ballpit {

void SettingOptions::add_to(CommandOptions& command, const std::string& heading,
                            std::span<const std::string_view> names) {
  for (const SettingInfo& setting : setting_table()) {
    if (!names.empty() && std::find(names.begin(), names.end(), setting.name) == names.end()) continue;
    const std::string name(setting.name);
    CommandOption* option =
        command.add_option("--" + name, values_[name], std::string(setting.help) + ": " + setting.allowed());
    option->type_name(std::string(setting.value_name))->group(heading);
    options_.emplace_back(name, option);
  }
}

std::vector<GivenOption> SettingOptions::given() const {
  std::vector<GivenOption> result;
  for (const auto& [name, option] : options_) {
    if (option->is_given()) result.push_back({name, values_.find(name)->second});
  }
  return result;
}

void SceneArguments::add_to(CommandOptions& command) {
  scene_ = kDefaultScene;
  option_ = command.add_option("SCENE", scene_, "a built-in scene (see `ballpit list`) or a .toml file");
  option_->shows_default();
  settings_.add_to(command, "Simulation (default: what the scene asks for)");
}

void LookArguments::add_to(CommandOptions& command) {
  const auto add = [&](const char* name, std::string& text, const std::string& help, const char* type) {
    options_[name] = command.add_option(name, text, help)->type_name(type)->shows_default();
  };
  add("--overlay", overlays_, "what to draw over the spheres: none, or some of " + join(names_in(overlay_table())),
      "A,B,…");
  add("--color", coloring_, "what a sphere's colour says: " + join(names_in(coloring_table())), "NAME");
  add("--theme", theme_, join(names_in(themes())), "NAME");
  add("--ui-scale", ui_scale_, "size of the panel's text and widgets: 0.5 to 3", "FACTOR");
}

View LookArguments::view(const View& base) const {
  View result = base;
  const auto is_given = [&](const char* name) { return options_.at(name)->is_given(); };
  if (is_given("--overlay")) result.overlays = parse_overlays("--overlay", overlays_);
  if (is_given("--color")) result.coloring = parse_choice("--color", coloring_, names_in(coloring_table()));
  if (is_given("--theme")) result.theme = parse_choice("--theme", theme_, names_in(themes()));
  if (is_given("--ui-scale")) {
    result.ui_scale = static_cast<float>(
        parse_number("--ui-scale", ui_scale_, static_cast<double>(kSmallestUi), static_cast<double>(kLargestUi)));
  }
  return result;
}

}  // namespace ballpit
