// SPDX-License-Identifier: MIT
// The panel's sections, and the widgets that they are made of.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/keys.h"
#include "app/panel.h"
#include "core/numbers.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "scene/catalog.h"
#include "simulate/methods.h"

namespace ballpit {

namespace {

/// Where a slider is of use; other values can be typed.
struct SliderRange {
  std::string_view setting;
  float low, high;
  bool is_log, is_integer;
};
constexpr std::array kSliders{
    SliderRange{"cell-size", 0.25f, 8, true, false},  SliderRange{"skin", 0, 1, false, false},
    SliderRange{"iterations", 1, 64, true, true},     SliderRange{"compliance", 0, 1e-3f, false, false},
    SliderRange{"dt", 1e-4f, 1.0f / 30, true, false}, SliderRange{"substeps", 1, 32, true, true},
    SliderRange{"threads", 0, 16, false, true},
};

const SliderRange* slider_of(std::string_view setting) {
  const auto found =
      std::find_if(kSliders.begin(), kSliders.end(), [&](const auto& s) { return s.setting == setting; });
  return found == kSliders.end() ? nullptr : &*found;
}

/// What the program takes where a setting is left to it.
float value_in_use(const Settings& settings, std::string_view name) {
  if (name == "cell-size") return static_cast<float>(settings.cell_size.value_or(1));
  if (name == "skin") return static_cast<float>(skin_of(settings));
  if (name == "iterations") return float(settings.iterations.value_or(settings.response == "impulse" ? 4 : 1));
  if (name == "compliance") return static_cast<float>(settings.compliance);
  if (name == "dt") return static_cast<float>(settings.dt);
  if (name == "substeps") return float(settings.substeps);
  return float(settings.threads);
}

std::string scientific(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}

void row(const char* what, const std::string& value) {
  ImGui::TextUnformatted(what);
  ImGui::SameLine(0.45f * ImGui::GetWindowContentRegionMax().x);
  ImGui::TextUnformatted(value.c_str());
}

}  // namespace

/// A list to choose from: `entries` calls entry() for each.
template <class Visit>
void Panel::combo(const std::string& name, const std::string& label, const std::string& current, Visit&& entries) {
  ImGui::SetNextItemWidth(0.58f * ImGui::GetContentRegionAvail().x);
  const bool is_open = ImGui::BeginCombo((label + "##" + name).c_str(), current.c_str(), ImGuiComboFlags_HeightLarge);
  note(name);
  if (!is_open) return;
  entries();
  ImGui::EndCombo();
}

bool Panel::entry(const std::string& name, const std::string& label, bool is_current) {
  const bool is_chosen = ImGui::Selectable((label + "##" + name).c_str(), is_current);
  note(name);
  return is_chosen;
}

/// True once the slider is let go of, or a number was typed into it.
bool Panel::slider(const std::string& name, const std::string& label, float& value, float low, float high, bool is_log,
                   const char* format) {
  const auto edited = edited_.find(name);
  float shown = edited != edited_.end() ? edited->second : value;
  ImGui::SetNextItemWidth(0.58f * ImGui::GetContentRegionAvail().x);
  const ImGuiSliderFlags flags = is_log ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
  if (ImGui::SliderFloat((label + "##" + name).c_str(), &shown, low, high, format, flags)) edited_[name] = shown;
  note(name);
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  value = shown;
  edited_.erase(name);
  return true;
}

void Panel::number_setting(Demo& demo, const SettingInfo& info) {
  const std::string name(info.name);
  if (const SliderRange* range = slider_of(info.name)) {
    float value = value_in_use(demo.session.settings(), info.name);
    if (slider(name, name, value, range->low, range->high, range->is_log, range->is_integer ? "%.0f" : "%.4g")) {
      std::array<char, 32> text;
      std::snprintf(text.data(), text.size(), range->is_integer ? "%.0f" : "%.6g", double(value));
      demo.set(name, text.data());
    }
  } else {
    std::string& text = typed_[name];
    if (text.empty()) text = info.get(demo.session.settings());
    ImGui::SetNextItemWidth(0.58f * ImGui::GetContentRegionAvail().x);
    const bool is_entered = ImGui::InputText((name + "##" + name).c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue);
    note(name);
    if (is_entered) demo.set(name, text);
    if (!ImGui::IsItemActive()) text.clear();
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s: %s", std::string(info.help).c_str(), info.allowed().c_str());
}

/// One shared option, as its table describes it. Names that the response does not go with are not offered.
void Panel::setting(Demo& demo, const SettingInfo& info) {
  if (!info.choices) {
    number_setting(demo, info);
    return;
  }
  const std::string name(info.name), current = info.get(demo.session.settings());
  combo(name, name, current, [&] {
    for (const std::string_view choice : info.choices()) {
      if (info.name != "response" && !goes_with(demo.session.settings().response, info.name, choice)) continue;
      if (entry(name + " " + std::string(choice), std::string(choice), choice == current))
        demo.set(name, std::string(choice));
    }
  });
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(info.help).c_str());
}

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
  if (slider("speed", "times real time", speed, 0.01f, 10, true, "%.2f")) demo.player.speed = speed;
}

void Panel::draw_detection(Demo& demo) {
  if (!ImGui::CollapsingHeader("Detection", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const Settings& settings = demo.session.settings();
  for (const Method& method : methods()) {
    if (method.family != Family::broadphase) continue;
    const std::string name(method.name);
    if (ImGui::RadioButton(std::string(method.label).c_str(), settings.broadphase == method.name)) {
      demo.set("broadphase", name);
    }
    note("broadphase " + name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(method.cost).c_str());
  }
  const Method& method = find_method(Family::broadphase, settings.broadphase);
  for (const SettingInfo& info : setting_table()) {
    const bool is_kind = info.name == "cell-size" || info.name == "table" || info.name == "axis";
    if (info.group != SettingGroup::detection || info.name == "broadphase") continue;
    if (is_kind && !uses(method, info.name)) continue;
    setting(demo, info);
    if (info.name == "cell-size") ImGui::TextDisabled("1 = 2·r_max: every contact;  0.5 = r: slide 7's bound");
  }
}

void Panel::draw_response(Demo& demo) {
  if (!ImGui::CollapsingHeader("Response", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const Method& method = find_method(Family::response, demo.session.settings().response);
  for (const SettingInfo& info : setting_table()) {
    if (info.group == SettingGroup::response && (info.name == "response" || uses(method, info.name)))
      setting(demo, info);
  }
  Physics physics = demo.session.scene().physics;
  auto restitution = static_cast<float>(physics.restitution);
  if (slider("restitution", "restitution", restitution, 0, 1, false, "%.2f")) {
    physics.restitution = physics.wall_restitution = restitution;
    demo.set_physics(physics);
  }
  auto stiffness = static_cast<float>(physics.stiffness);
  if (method.name == "penalty" && slider("stiffness", "stiffness [N/m]", stiffness, 1e2f, 1e8f, true, "%.3g")) {
    physics.stiffness = stiffness;
    demo.set_physics(physics);
  }
  for (const SettingInfo& info : setting_table()) {
    if (info.group == SettingGroup::time) setting(demo, info);
  }
}

void Panel::draw_view(Demo& demo) {
  if (!ImGui::CollapsingHeader("Overlays", ImGuiTreeNodeFlags_DefaultOpen)) return;
  for (const OverlayEntry& overlay : overlay_table()) {
    bool is_shown = demo.view.shows(overlay.name);
    if (ImGui::Checkbox(std::string(overlay.label).c_str(), &is_shown)) {
      demo.view.toggle(overlay.name);
      demo.touch();
    }
    note("overlay " + std::string(overlay.name));
  }
  combo("color", "colour", std::string(coloring_named(demo.view.coloring).label), [&] {
    for (const ColoringEntry& coloring : coloring_table()) {
      const std::string name(coloring.name);
      if (!entry("color " + name, std::string(coloring.label), coloring.name == demo.view.coloring)) continue;
      demo.view.coloring = name;
      demo.touch();
    }
  });
  combo("theme", "theme", std::string(theme_named(demo.view.theme).label), [&] {
    for (const Theme& theme : themes()) {
      const std::string name(theme.name);
      if (!entry("theme " + name, std::string(theme.label), theme.name == demo.view.theme)) continue;
      demo.view.theme = name;
      demo.touch();
    }
  });
  if (button("save", "save picture")) wants_picture = true;
}

void Panel::draw_selected(Demo& demo) {
  const int64_t i = demo.view.selected;
  const Inspection& inspection = demo.inspection();
  if (i < 0 || i >= inspection.bodies.count) return;
  if (!ImGui::CollapsingHeader("Selected sphere", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const Vec3 p = inspection.bodies.position_of(i);
  row("sphere", std::to_string(i));
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "%.3f, %.3f, %.3f m", double(p.x), double(p.y), double(p.z));
  row("place", text.data());
  std::vector<int> touched;
  for (const Pair& pair : inspection.contacts) {
    if (pair.i == i) touched.push_back(pair.j);
    if (pair.j == i) touched.push_back(pair.i);
  }
  row("touches", touched.empty() ? "none" : std::to_string(touched.size()));
  if (!inspection.grids.empty()) {
    const GridInspection& grid = inspection.grids.front();
    const Vec3 cell = (p - grid.origin) / grid.edge;
    const int x = int(cell.x), y = int(cell.y), z = inspection.bodies.dimensions == 3 ? int(cell.z) : 0;
    row("cell", std::to_string((z * grid.cells.y + y) * grid.cells.x + x));
  }
}

void Panel::draw_cost(Demo& demo) {
  if (!ImGui::CollapsingHeader("Cost", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const Report& report = demo.report();
  const std::vector<float> times(demo.player.step_times().begin(), demo.player.step_times().end());
  row("spheres", grouped(report.count));
  const bool is_played = !demo.player.step_times().empty();
  const double mean =
      is_played ? demo.player.mean_step_time() : 1e3 * report.seconds / double(std::max<int64_t>(report.steps, 1));
  row("a step", three_digits(mean) + " ms");
  row("candidates", grouped(report.candidates));
  row("contacts", grouped(report.contacts));
  row("by", report.broadphase + ", " + demo.session.backend());
  const float height = 3 * ImGui::GetTextLineHeight();
  ImGui::PlotLines("##times", times.data(), static_cast<int>(times.size()), 0, "ms a step", 0, FLT_MAX,
                   {ImGui::GetContentRegionAvail().x, height});
  double sum = 0;
  for (const Stage& stage : report.stages) sum += stage.seconds;
  for (const Stage& stage : report.stages) {
    const auto part = static_cast<float>(stage.seconds / std::max(sum, 1e-12));
    if (part >= 0.05f) ImGui::ProgressBar(part, {ImGui::GetContentRegionAvail().x, 0}, stage.name.c_str());
  }
}

void Panel::draw_accuracy(Demo& demo) {
  if (!ImGui::CollapsingHeader("Accuracy", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const Report& report = demo.report();
  const double energy = report.kinetic_energy + report.potential_energy + report.elastic_energy;
  const double start = demo.energy_at_start();
  row("energy", three_digits(energy) + " J");
  if (start != 0)
    row("since its start", (energy >= start ? "+" : "−") + scientific(std::fabs((energy - start) / start)));
  row("largest overlap", scientific(report.max_overlap) + " r");
  const Vec3d& p = report.momentum;
  row("momentum", scientific(length(p)) + " kg·m/s");
  if (demo.view.shows("pairs")) row("missed contacts", std::to_string(demo.inspection().missed.size()));
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
    ImGui::SameLine(110 * sheet_.unit());
    ImGui::TextUnformatted(std::string(key.help).c_str());
  }
  ImGui::TextDisabled("drag: turn   wheel: closer   click: pick a sphere");
  ImGui::End();
}

}  // namespace ballpit
