// SPDX-License-Identifier: MIT
// The sections with controls: time, detection, response, view, export. Sections with figures: panel_figures.cpp.
#include <algorithm>
#include <array>

#include <imgui.h>

#include "methods/methods.h"
#include "render/overlays/overlay.h"
#include "scene/read_scene.h"
#include "window/panel.h"

namespace ballpit {

namespace {

constexpr std::array kFilmSizes{"640x360", "1280x720", "1920x1080", "3840x2160"};
constexpr float kMaxFrames = 3600;

}  // namespace

void Panel::draw_time(Demo& demo) {
  const Scene& scene = demo.session.scene();
  combo("scene", "scene", scene.title.empty() ? scene.name : scene.title, [&] {
    for (const SceneInfo& info : built_in_scenes()) {
      if (entry("scene " + info.name, info.title, info.name == scene.name)) demo.load(info.name);
    }
  });
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", scene.description.c_str());
  if (button("restart", "|<")) demo.restart();
  ImGui::SameLine();
  if (button("back", "<")) demo.step_back();
  ImGui::SameLine();
  if (button("pause", demo.player.is_running ? "pause" : "play")) demo.player.is_running = !demo.player.is_running;
  ImGui::SameLine();
  if (button("step", ">")) demo.step();
  ImGui::SameLine();
  ImGui::Text("t = %.3f s", demo.session.time());
  auto moment = static_cast<int>(demo.timeline->step_now());
  ImGui::SetNextItemWidth(-1);
  const int first = static_cast<int>(demo.timeline->first());
  const int furthest = std::max(static_cast<int>(demo.timeline->furthest()), first + 1);
  if (ImGui::SliderInt("##timeline", &moment, first, furthest, "step %d")) {
    demo.go_to(moment);
  }
  note("timeline");
  auto speed = static_cast<float>(demo.player.speed);
  if (slider("speed", "times real time", speed, {0.01f, 10, true, "%.2f"})) demo.player.speed = speed;
}

void Panel::draw_detection(Demo& demo) {
  if (!section("Detection")) return;
  const Settings& settings = demo.session.settings();
  for (const Method& method : methods()) {
    if (method.family != Family::broadphase || is_of_lecture(named<BroadPhase>(method.name))) continue;
    const std::string name(method.name);
    if (ImGui::RadioButton(std::string(method.label).c_str(), name_of(settings.broadphase) == method.name)) {
      demo.set("broadphase", name);
    }
    note("broadphase " + name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(method.cost).c_str());
  }
  const Method& method = find_method(settings.broadphase);
  for (const SettingInfo& info : setting_table()) {
    const bool is_kind = info.name == "cell-size" || info.name == "table" || info.name == "axis";
    if (info.group != SettingGroup::detection || info.name == "broadphase") continue;
    if (is_kind && !uses(method, info.name)) continue;
    setting(demo, info);
  }
}

void Panel::draw_response(Demo& demo) {
  if (!section("Response")) return;
  const Method& method = find_method(demo.session.settings().response);
  for (const SettingInfo& info : setting_table()) {
    if (info.group == SettingGroup::response && (info.name == "response" || uses(method, info.name)))
      setting(demo, info);
  }
  Physics physics = demo.session.scene().physics;
  auto restitution = static_cast<float>(physics.restitution);
  if (slider("restitution", "restitution", restitution, {0, 1, false, "%.2f"})) {
    physics.restitution = physics.wall_restitution = restitution;
    demo.set_physics(physics);
  }
  auto stiffness = static_cast<float>(physics.stiffness);
  if (demo.session.settings().response == Response::penalty &&
      slider("stiffness", "stiffness [N/m]", stiffness, {1e2f, 1e8f, true, "%.3g"})) {
    physics.stiffness = stiffness;
    demo.set_physics(physics);
  }
  for (const SettingInfo& info : setting_table()) {
    if (info.group == SettingGroup::time) setting(demo, info);
  }
}

/// A drop-down list with an entry for each row of a table.
template <class Table>
void Panel::choose(Demo& demo, const char* name, const char* label, const Table& table, std::string& current) {
  const auto shown = std::find_if(table.begin(), table.end(), [&](const auto& e) { return e.name == current; });
  combo(name, label, std::string(shown->label), [&] {
    for (const auto& choice : table) {
      const std::string own(choice.name);
      if (!entry(std::string(name) + " " + own, std::string(choice.label), choice.name == current)) continue;
      current = own;
      demo.touch();
    }
  });
}

void Panel::draw_view(Demo& demo) {
  if (!section("Overlays")) return;
  View& view = demo.view;
  for (const OverlayEntry& overlay : overlay_table()) {
    bool is_shown = view.shows(overlay.name);
    if (ImGui::Checkbox(std::string(overlay.label).c_str(), &is_shown)) {
      view.toggle(overlay.name);
      demo.touch();
    }
    note("overlay " + std::string(overlay.name));
    const std::string lack = view.shows(overlay.name) ? overlay.lack(demo.inspection()) : "";
    if (lack.empty()) continue;
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", lack.c_str());
    ImGui::PopTextWrapPos();
    note("lack of " + std::string(overlay.name));
  }
  choose(demo, "color", "colour", coloring_table(), view.coloring);
  choose(demo, "theme", "theme", themes(), view.theme);
  if (slider("ui-scale", "panel size", view.ui_scale, {kMinUiScale, kMaxUiScale, true, "%.2f"})) {
    view.ui_scale = std::clamp(view.ui_scale, kMinUiScale, kMaxUiScale);  // a typed number may be any
    demo.touch();
  }
}

void Panel::draw_export() {
  if (!section("Export")) return;
  if (button("save", "save picture")) requests.picture = true;
  ImGui::SameLine();
  if (button("save state", "save state (CSV)")) requests.state = true;
  combo("film size", "size of frames", requests.film_size, [&] {
    for (const std::string size : kFilmSizes) {
      if (entry("film size " + size, size, size == requests.film_size)) requests.film_size = size;
    }
  });
  auto frames = static_cast<float>(requests.film_frames);
  if (slider("film frames", "frames, 60 a second", frames, {1, kMaxFrames, true, "%.0f"})) {
    requests.film_frames = static_cast<int>(std::clamp(frames, 1.0f, kMaxFrames));
  }
  if (button("film", is_filming ? "stop" : "export frames")) requests.film = true;
}

void Panel::draw_keys(Demo& demo) {
  if (!demo.shows_keys) return;
  ImGui::SetNextWindowPos(
      {0.5f * static_cast<float>(sheet_.picture_width()), 0.5f * static_cast<float>(sheet_.height())}, ImGuiCond_Always,
      {0.5f, 0.5f});
  ImGui::Begin("Keys", &demo.shows_keys,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  for (const Key& key : key_table()) {
    ImGui::TextUnformatted(std::string(key.name).c_str());
    ImGui::SameLine(5 * ImGui::GetFontSize());
    ImGui::TextUnformatted(std::string(key.help).c_str());
  }
  ImGui::TextDisabled("drag: turn   wheel: closer   click: pick a sphere");
  ImGui::End();
}

}  // namespace ballpit
