// SPDX-License-Identifier: MIT
#include "cli/options.h"

#include "core/language.h"
#include "render/overlays/overlay.h"
#include "show/comparison.h"
#include "show/notes.h"

namespace ballpit {

void add_settings(CommandOptions& command, const std::string& heading, std::vector<GivenOption>& given,
                  std::span<const std::string_view> names) {
  for (const SettingInfo& setting : setting_table()) {
    if (!names.empty() && std::find(names.begin(), names.end(), setting.name) == names.end()) continue;
    command.add({.name = "--" + std::string(setting.name),
                 .type = std::string(setting.value_name),
                 .help = fmt::format("{}: {}{}", setting.help, setting.allowed,
                                     names.empty() ? "; default: " + setting.preset : ""),
                 .group = heading},
                [&given, &setting](const std::string& text) {
                  given.push_back({std::string(setting.name), text});
                });
  }
}

void warn_of_run(Session& session) {
  warn_of_small_cells(session.settings());
  if (session.choice()) return;
  Scene scene = session.scene();
  scene.bodies = session.world().bodies();
  for (const std::string& warning : warnings_of(scene, session.settings())) warn(session.scene().name, warning);
}

void SceneArguments::add_to(CommandOptions& command) {
  command.add({"SCENE", "", "a built-in scene (see `ballpit list`) or a .toml file", scene},
              [this](const std::string& text) {
                scene = text;
                is_scene_given = true;
              });
  add_settings(command, "Simulation (the scene may have other defaults)", given);
}

void ActsArgument::add_to(CommandOptions& command) {
  command.add_path(
      {"--acts", "FILE", "throw, push and drop spheres as this file says, a TOML file such as `show` saves"}, path);
}

std::vector<Act> ActsArgument::read(Session& session) const {
  return path.empty() ? std::vector<Act>{} : read_acts(path, session.scene(), session.world().bodies());
}

void add_language(CommandOptions& command) {
  command.add({"--lang", "NAME", "language: " + join(kNames<Language>), std::string(name_of(Language::english))},
              [](const std::string& text) {
                const std::optional<Language> chosen = find_named<Language>(text);
                if (!chosen) throw UserError("--lang", text, join(kNames<Language>));
                set_language(*chosen);
              });
}

void add_text_scale(CommandOptions& command, std::optional<float>& scale, float preset) {
  command.add_number({"--text-scale", "FACTOR", "size of the text in the scene", typed(preset)}, scale,
                     Range{kMinUiScale, kMaxUiScale});
}

void LookArguments::add_to(CommandOptions& command) {
  const auto add_name = [&](const char* name, const std::string& help, const std::vector<std::string>& names,
                            const std::string& shown, std::optional<std::string>& chosen) {
    command.add({name, "NAME", help + join(names), shown},
                [&chosen, name, names](const std::string& text) { chosen = parse_choice(name, text, names); });
  };
  command.add(
      {"--overlay", "A,B,…", "what to draw over the spheres: none, or some of " + join(names_in(overlay_table())),
       join(preset.overlays, ",")},
      [this](const std::string& text) { overlays = parse_overlays("--overlay", text); });
  add_name("--color", "what a sphere's colour shows: ", names_in(coloring_table()), preset.coloring, coloring);
  add_name("--theme", "", names_in(themes()), preset.theme, theme);
  command.add({"--occlusion", "on|off", "darken spheres and floor where spheres hide the sky or the light",
               preset.occlusion ? "on" : "off"},
              [this](const std::string& text) {
                occlusion = parse_choice("--occlusion", text, {"on", "off"});
              });
  command.add({"--caption", "on|off", "the scene's title above it, and below it how many tests find its contacts",
               preset.has_caption ? "on" : "off"},
              [this](const std::string& text) {
                has_caption = parse_choice("--caption", text, {"on", "off"}) == "on";
              });
  const std::string turns = turn_of_default != 0 ? fmt::format(" ({:g} without SCENE)", turn_of_default) : "";
  command.add_number({"--turn", "DEGREES", "the camera turns about the vertical, in degrees a simulated second" + turns,
                      typed(preset.turn)},
                     turn, Range{-kFastestTurn, kFastestTurn});
  command.add({"--compare", "A,B,…", "split the picture: the scene by two to four broad phases, with counts of tests"},
              [this](const std::string& text) { compared = parse_comparison(text); });
  command.add_number({"--ui-scale", "FACTOR", "size of the panel's text and widgets", typed(preset.ui_scale)}, ui_scale,
                     Range{kMinUiScale, kMaxUiScale});
  add_text_scale(command, text_scale, preset.text_scale);
  add_language(command);
}

View LookArguments::view(View base) const {
  base.overlays = overlays.value_or(base.overlays);
  base.coloring = coloring.value_or(base.coloring);
  base.theme = theme.value_or(base.theme);
  if (occlusion) base.occlusion = *occlusion == "on";
  base.has_caption = has_caption.value_or(base.has_caption);
  base.turn = turn.value_or(base.turn);
  base.ui_scale = ui_scale.value_or(base.ui_scale);
  base.text_scale = text_scale.value_or(base.text_scale);
  return base;
}

void LookArguments::check(const SceneArguments& scene, PictureSize size) const {
  if (compared.empty()) return;
  check_compared(scene.given);
  check_views_fit(size, compared.size());
}

void LookArguments::apply(Demo& demo, const View& base) const {
  const Scene& scene = demo.session.scene();
  if (turn && *turn != 0 && scene.domain.dimensions == 2) {
    throw UserError("--turn", fmt::format("{:g} with {}, which is planar", *turn, scene.name),
                    "0, or a scene of three dimensions");
  }
  demo.view = view(base);
  if (!compared.empty()) demo.compare(compared);
  demo.touch();
}

}  // namespace ballpit
