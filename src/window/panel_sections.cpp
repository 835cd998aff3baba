// SPDX-License-Identifier: MIT
// The controls: time, the tabs Scene and Method, the list of keys. The tab with figures: panel_figures.cpp.
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <imgui.h>

#include "core/language.h"
#include "core/numbers.h"
#include "core/phrase.h"
#include "methods/methods.h"
#include "render/overlays/overlay.h"
#include "scene/read_scene.h"
#include "window/panel.h"

namespace ballpit {

namespace {

constexpr std::array kFilmSizes{"640x360", "1280x720", "1920x1080", "3840x2160"};
constexpr float kMaxFrames = 3600;
constexpr float kFastTurn = 30;  // [°/s] on the slider; a faster one can be typed

/// The next button stays in the line of the item before if it fits there.
void keep_line_for(const std::string& label) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = style.ItemSpacing.x + ImGui::CalcTextSize(label.c_str()).x + 2 * style.FramePadding.x;
  const float right = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  if (right + width <= ImGui::GetWindowContentRegionMax().x) ImGui::SameLine();
}

}  // namespace

void Panel::draw_time(Demo& demo) {
  const Scene& scene = demo.session.scene();
  const bool is_german = language() == Language::german;
  const auto title = [&](const SceneInfo& info) { return is_german ? info.title_de : info.title; };
  combo("scene", "scene", title(scene).empty() ? scene.name : title(scene), [&] {
    for (const SceneInfo& info : built_in_scenes()) {
      if (entry("scene " + info.name, title(info), info.name == scene.name)) demo.load(info.name);
    }
  });
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s", (is_german ? scene.description_de : scene.description).c_str());
  }
  if (button("restart", "|<")) demo.restart();
  ImGui::SameLine();
  if (button("back", "<")) demo.step_back();
  ImGui::SameLine();
  if (button("pause", translated(demo.player.is_running ? "pause" : "play"))) {
    demo.player.is_running = !demo.player.is_running;
  }
  ImGui::SameLine();
  if (button("step", ">")) demo.step();
  const std::string time = fmt::format("t = {} s", local_number(fmt::format("{:.3f}", demo.session.time())));
  ImGui::SameLine();
  if (ImGui::CalcTextSize(time.c_str()).x > ImGui::GetContentRegionAvail().x) ImGui::NewLine();
  ImGui::TextUnformatted(time.c_str());
  note("time");
  auto moment = static_cast<int>(demo.timeline->step_now());
  ImGui::SetNextItemWidth(-1);
  const int first = static_cast<int>(demo.timeline->first());
  const int furthest = std::max(static_cast<int>(demo.timeline->furthest()), first + 1);
  if (ImGui::SliderInt("##timeline", &moment, first, furthest, (translated("step") + " %d").c_str())) {
    demo.go_to(moment);
  }
  note("timeline");
  auto speed = static_cast<float>(demo.player.speed);
  const std::string reached = demo.player.reached() > 0 ? fmt::format("{:.2g} × ({} {:.2f} ×)", speed,
                                                                      translated("reached"), demo.player.reached())
                                                        : fmt::format("{:.2g} ×", speed);
  if (slider("speed", "real time", speed,
             {.low = 0.01f, .high = 10, .is_log = true, .shown = local_number(reached), .snaps = {0.1f, 0.5f, 1, 2}})) {
    demo.player.speed = speed;
  }
  for (const PanelKey& key : keys) {
    if (!key.act) continue;
    const std::string label = translated(key.help);
    keep_line_for(label);
    if (button("key " + key.name, label)) chosen_ = key.act;
  }
}

void Panel::draw_broad_phases(Demo& demo) {
  if (demo.is_comparing()) {
    for (size_t k = 0; k < demo.view_count(); ++k) {
      const Report& report = demo.view_at(k).report();
      row(find_method(named<BroadPhase>(report.broadphase)).label.data(), counted(report.candidates, "test"));
    }
    return;
  }
  const std::string_view current = name_of(demo.session.settings().broadphase);
  const auto radio = [&](const Method& method, const std::string& label) {
    const std::string name(method.name);
    if (ImGui::RadioButton((label + "##" + name).c_str(), current == method.name)) demo.set("broadphase", name);
    note("broadphase " + name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(method.cost).c_str());
  };
  for (const Method& method : methods()) {
    if (method.family != Family::broadphase || is_of_lecture(named<BroadPhase>(method.name))) continue;
    radio(method, translated(method.label));
    const std::optional<BroadPhase> of_lecture = find_named<BroadPhase>("lecture/" + std::string(method.name));
    if (!of_lecture) continue;
    const std::string label = translated("as on the slides");
    const float needed =
        ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label.c_str()).x;
    const float right = ImGui::GetWindowContentRegionMax().x, at = std::min(0.55f * right, right - needed);
    if (at > ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x) ImGui::SameLine(at);
    radio(find_method(*of_lecture), label);
  }
}

void Panel::draw_physics(Demo& demo) {
  Physics physics = demo.session.scene().physics;
  auto restitution = static_cast<float>(physics.restitution);
  if (slider("restitution", "restitution", restitution,
             {.low = 0, .high = 1, .shown = local_number(fmt::format("{:.2f}", restitution))})) {
    physics.restitution = physics.wall_restitution = restitution;
    demo.set_physics(physics);
  }
  auto stiffness = static_cast<float>(physics.stiffness);
  ImGui::BeginDisabled(demo.session.settings().response != Response::penalty);
  if (slider("stiffness", "stiffness", stiffness,
             {.low = 1e2f, .high = 1e8f, .is_log = true, .shown = with_unit(physics.stiffness, "N/m", true)})) {
    physics.stiffness = stiffness;
    demo.set_physics(physics);
  }
  ImGui::EndDisabled();
}

void Panel::draw_method(Demo& demo) {
  draw_choice(demo);
  heading("Detection");
  draw_broad_phases(demo);
  settings(demo, SettingGroup::detection, find_method(demo.session.settings().broadphase));
  heading("Response");
  settings(demo, SettingGroup::response, find_method(demo.session.settings().response));
  draw_physics(demo);
  heading("Time");
  settings(demo, SettingGroup::time, find_method(demo.session.settings().response));
}

/// A drop-down list with an entry for each row of a table.
template <class Table>
void Panel::choose(Demo& demo, const char* name, const char* label, const Table& table, std::string& current) {
  const auto shown = std::find_if(table.begin(), table.end(), [&](const auto& e) { return e.name == current; });
  combo(name, label, translated(shown->label), [&] {
    for (const auto& choice : table) {
      const std::string own(choice.name);
      if (!entry(std::string(name) + " " + own, translated(choice.label), choice.name == current)) continue;
      current = own;
      demo.touch();
    }
  });
}

/// The switch of ambient occlusion, and what it costs, or why nothing is seen of it.
void Panel::draw_occlusion(Demo& demo) {
  bool& is_on = demo.view.occlusion;
  ImGui::BeginDisabled(demo.session.scene().domain.dimensions == 2);
  if (ImGui::Checkbox((translated("ambient occlusion") + "##occlusion").c_str(), &is_on)) demo.touch();
  note("occlusion");
  ImGui::EndDisabled();
  if (demo.session.scene().domain.dimensions == 2 || !is_on) return;
  if (!demo.shows_occlusion(sheet_.height())) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", translated("spheres are too small here to show it").c_str());
    ImGui::PopTextWrapPos();
    note("lack of occlusion");
  } else if (demo.measures && demo.writing_time > 0) {
    const std::string time = local_number(three_digits(1000 * demo.writing_time));
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", phrase("{} ms a picture to find who hides whom", time).c_str());
    ImGui::PopTextWrapPos();
    note("cost of occlusion");
  }
}

void Panel::draw_scene(Demo& demo) {
  View& view = demo.view;
  heading("Overlays");
  for (const OverlayEntry& overlay : overlay_table()) {
    bool is_drawn = view.shows(overlay.name);
    if (ImGui::Checkbox((translated(overlay.label) + "##" + std::string(overlay.name)).c_str(), &is_drawn)) {
      view.toggle(overlay.name);
      demo.touch();
    }
    note("overlay " + std::string(overlay.name));
    const std::string lack = demo.lack_of(overlay);
    if (lack.empty()) continue;
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", translated(lack).c_str());
    ImGui::PopTextWrapPos();
    note("lack of " + std::string(overlay.name));
  }
  heading("Look");
  choose(demo, "color", "colour", coloring_table(), view.coloring);
  choose(demo, "theme", "theme", themes(), view.theme);
  const auto scale = [&](const char* name, const char* label, float& value) {
    const std::string shown = local_number(fmt::format("{:.2g} ×", value));
    const bool is_own = &value == &view.ui_scale;
    const SliderLook look{
        .low = kMinUiScale, .high = kMaxUiScale, .is_log = true, .is_late = is_own, .shown = shown, .snaps = {1}};
    if (!slider(name, label, value, look)) return;
    value = std::clamp(value, kMinUiScale, kMaxUiScale);  // a typed number may be any
    demo.touch();
  };
  draw_occlusion(demo);
  if (pages.titles.empty()) {  // a lecture's pages have their own
    if (ImGui::Checkbox((translated("caption") + "##caption").c_str(), &view.has_caption)) demo.touch();
    note("caption");
    ImGui::BeginDisabled(demo.session.scene().domain.dimensions == 2);
    float turn = view.turn;
    const std::string shown = local_number(fmt::format("{:.3g} °/s", turn));
    if (slider("turn", "turn", turn, {.low = 0, .high = kFastTurn, .shown = shown, .snaps = {0, kSlowTurn}})) {
      view.set_turn(std::clamp(turn, -kFastestTurn, kFastestTurn), demo.session.time());
      demo.touch();
    }
    ImGui::EndDisabled();
  }
  scale("text-scale", "text in the scene", view.text_scale);
  scale("ui-scale", "panel", view.ui_scale);
  const auto speak = [&](const char* name, const char* label, Language spoken) {
    if (ImGui::RadioButton(label, language() == spoken)) {
      set_language(spoken);
      demo.touch();
    }
    note(name);
  };
  speak("language en", "English", Language::english);
  ImGui::SameLine();
  speak("language de", "Deutsch", Language::german);
  draw_export(demo);
}

void Panel::draw_export(Demo& demo) {
  heading("Export");
  if (button("save", translated("save picture"))) requests.picture = true;
  const std::string state = translated("save state (CSV)");
  keep_line_for(state);
  if (button("save state", state)) requests.state = true;
  if (!gestures.empty()) {
    const std::string acts = translated("save acts");
    keep_line_for(acts);
    ImGui::BeginDisabled(demo.session.acts().all().empty());
    if (button("save acts", acts)) requests.acts = true;
    ImGui::EndDisabled();
  }
  combo("film size", "size of frames", requests.film_size, [&] {
    for (const std::string size : kFilmSizes) {
      if (entry("film size " + size, size, size == requests.film_size)) requests.film_size = size;
    }
  });
  auto frames = static_cast<float>(requests.film_frames);
  const std::string shown =
      fmt::format("{} = {}", requests.film_frames, with_unit(requests.film_frames / 60.0, "s", true));
  if (slider("film frames", "frames", frames,
             {.low = 1, .high = kMaxFrames, .is_log = true, .is_integer = true, .shown = shown})) {
    requests.film_frames = static_cast<int>(std::clamp(frames, 1.0f, kMaxFrames));
  }
  if (button("film", translated(is_filming ? "stop" : "export frames"))) requests.film = true;
}

void Panel::draw_pages() {
  const auto text_of = [&](int number) {
    return std::to_string(number) + "  " + pages.titles[static_cast<size_t>(number - 1)];
  };
  int chosen = 0;
  combo("page", "page", text_of(pages.number), [&] {
    for (int number = 1; number <= static_cast<int>(pages.titles.size()); ++number) {
      if (entry("page " + std::to_string(number), text_of(number), number == pages.number)) chosen = number;
    }
  });
  if (chosen > 0) chosen_ = [go_to = pages.go_to, chosen] { go_to(chosen); };
}

void Panel::draw_keys(Demo& demo) {
  heading("Keys");
  for (const std::string& gesture : gestures) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", translated(gesture).c_str());
    ImGui::PopTextWrapPos();
  }
  for (const PanelKey& key : keys) {
    ImGui::TextUnformatted(key.name.c_str());
    ImGui::SameLine(5 * ImGui::GetFontSize());
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(translated(key.help).c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::TextDisabled("%s", translated("drag: turn   wheel: closer   click: pick a sphere").c_str());
  if (button("close keys", translated("close"))) demo.shows_keys = false;
}

}  // namespace ballpit
