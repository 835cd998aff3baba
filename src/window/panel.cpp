// SPDX-License-Identifier: MIT
#include "window/panel.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <set>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "core/language.h"

namespace ballpit {

namespace {

constexpr float kWidth = 470;  // in 1/1080 of the height

ImVec4 im(const Vec3& color, float opacity = 1) { return {color.r, color.g, color.b, opacity}; }

void style_for(const Theme& theme, float unit) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  const bool is_dark = theme.background.r < 0.5f;
  is_dark ? ImGui::StyleColorsDark() : ImGui::StyleColorsLight();
  style.Colors[ImGuiCol_WindowBg] = im(is_dark ? theme.background * 1.25f : Vec3(0.965f));
  style.Colors[ImGuiCol_Text] = im(theme.text);
  style.Colors[ImGuiCol_TextDisabled] = im(theme.text, 0.7f);
  for (const ImGuiCol accent : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive,
                                ImGuiCol_PlotHistogram, ImGuiCol_PlotLines}) {
    style.Colors[accent] = im(theme.grid);
  }
  for (const ImGuiCol grab : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) {
    style.Colors[grab].w = 0.6f;  // so that the number on it can be read
  }
  style.Colors[ImGuiCol_Border] = im(theme.text, 0.25f);
  style.FrameBorderSize = 1;
  style.WindowRounding = 0;
  style.FrameRounding = 5;
  style.GrabRounding = 5;
  style.WindowPadding = {18, 14};
  style.FramePadding = {9, 5};
  style.ItemSpacing = {9, 7};
  style.GrabMinSize = 16;
  style.ScrollbarSize = 16;
  style.ScaleAllSizes(std::max(unit, 0.4f));
  style.AntiAliasedLinesUseTex = false;
}

/// GLFW's codes of the keys that text fields know.
void map_keys(ImGuiIO& io) {
  constexpr std::pair<ImGuiKey, int> kCodes[] = {
      {ImGuiKey_Tab, 258},       {ImGuiKey_LeftArrow, 263}, {ImGuiKey_RightArrow, 262},  {ImGuiKey_UpArrow, 265},
      {ImGuiKey_DownArrow, 264}, {ImGuiKey_Home, 268},      {ImGuiKey_End, 269},         {ImGuiKey_Delete, 261},
      {ImGuiKey_Backspace, 259}, {ImGuiKey_Enter, 257},     {ImGuiKey_KeyPadEnter, 335}, {ImGuiKey_Escape, 256}};
  for (const auto& [key, code] : kCodes) io.KeyMap[key] = code;
}

void feed(ImGuiIO& io, const PanelInput& input, const Sheet& sheet) {
  io.DisplaySize = {static_cast<float>(sheet.picture_width()), static_cast<float>(sheet.picture_height())};
  io.DeltaTime = std::max(input.elapsed, 1e-4f);
  io.MousePos = input.mouse.x > -1e5f ? ImVec2{input.mouse.x, input.mouse.y} : ImVec2{-FLT_MAX, -FLT_MAX};
  io.MouseDown[0] = input.is_down;
  io.MouseWheel = input.wheel;
  for (const auto& [key, is_down] : input.keys) {
    if (key >= 0 && key < 512) io.KeysDown[key] = is_down;
  }
  // Tab hides the panel and shows it. From outside of a text field it would make one of a slider, which takes all keys.
  if (!io.WantTextInput) io.KeysDown[io.KeyMap[ImGuiKey_Tab]] = false;
  const auto either = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
  io.KeyShift = either(340, 344);
  io.KeyCtrl = either(341, 345);
  io.KeyAlt = either(342, 346);
  io.KeySuper = either(343, 347);
  for (const char32_t character : input.typed) io.AddInputCharacter(character);
}

}  // namespace

Panel::Panel(Sheet& sheet) : sheet_(sheet) {
  ImGui::SetCurrentContext(sheet_.context());
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigInputTextCursorBlink = false;  // nothing blinks
  map_keys(io);
}

int Panel::width_in(int picture_width, int picture_height, float scale) {
  const float wanted = kWidth * scale * static_cast<float>(picture_height) / 1080;
  return std::min(picture_width / (scale > 1 ? 2 : 3), static_cast<int>(wanted));
}

int width_beside(const Panel& panel, PictureSize size, float scale) {
  return panel.is_shown ? Panel::width_in(size.width, size.height, scale) : 0;
}

bool bring_into_view(Panel& panel, const std::string& name, const std::function<void()>& draw) {
  const auto has_item = [&] { return panel.items().contains(name); };
  for (const PanelTab tab : kPanelTabs) {
    if (has_item()) break;
    panel.open(tab);
    draw();  // ImGui shows a new tab in the frame after
    draw();
  }
  if (!has_item()) return false;
  panel.reveal(name);
  draw();
  draw();
  return true;
}

std::vector<std::string> items_of_all_tabs(Panel& panel, const std::function<void()>& draw) {
  std::set<std::string> names;
  for (const PanelTab tab : kPanelTabs) {
    panel.open(tab);
    draw();
    draw();
    for (const auto& item : panel.items()) names.insert(item.first);
  }
  return {names.begin(), names.end()};
}

std::string Panel::place_label(const std::string& name, const std::string& label) {
  constexpr float kPart = 0.58f;  // of the width is the item's
  const std::string text = translated(label);
  const float width = ImGui::GetContentRegionAvail().x,
              room = (1 - kPart) * width - ImGui::GetStyle().ItemInnerSpacing.x;
  if (ImGui::CalcTextSize(text.c_str()).x <= room) {
    ImGui::SetNextItemWidth(kPart * width);
    return text + "##" + name;
  }
  ImGui::TextUnformatted(text.c_str());
  ImGui::SetNextItemWidth(-1);
  return "##" + name;
}

void Panel::note(const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool is_disabled = (ImGui::GetCurrentContext()->LastItemData.InFlags & ImGuiItemFlags_Disabled) != 0;
  items_[name] = {{low.x, low.y}, {high.x, high.y}, !is_disabled};
  if (name == revealed_) ImGui::SetScrollHereY();
}

void Panel::draw(Demo& demo, const PanelInput& input) {
  ImGui::SetCurrentContext(sheet_.context());
  sheet_.scale_panel(demo.view.ui_scale, density);
  feed(ImGui::GetIO(), input, sheet_);
  style_for(theme_named(demo.view.theme), sheet_.unit() * demo.view.ui_scale);
  items_.clear();
  demo.report();  // so that the history has every moment, whichever tab is open
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  is_shown ? draw_panel(demo) : draw_handle(input);
  if (shows_card) draw_card(demo);
  draw_hint(input.elapsed);
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  revealed_.clear();
  wanted_tab_.reset();
  if (const auto act = std::exchange(chosen_, nullptr)) act();
}

void Panel::draw_panel(Demo& demo) {
  ImGui::SetNextWindowPos({0, 0});
  const auto width = static_cast<float>(width_in(sheet_.picture_width(), sheet_.picture_height(), demo.view.ui_scale));
  ImGui::SetNextWindowSize({width, static_cast<float>(sheet_.picture_height())});
  ImGui::Begin("Ballpit", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  if (!pages.titles.empty()) draw_pages();
  draw_time(demo);
  const std::string& trouble = demo.player.failure().empty() ? demo.message() : demo.player.failure();
  if (!trouble.empty()) ImGui::TextWrapped("%s", trouble.c_str());
  demo.shows_keys ? draw_keys(demo) : draw_tabs(demo);
  ImGui::End();
}

void Panel::draw_tabs(Demo& demo) {
  struct Tab {
    PanelTab tab;
    const char* label;
    void (Panel::*draw)(Demo&);
  };
  static constexpr std::array kTabs{Tab{PanelTab::scene, "Scene", &Panel::draw_scene},
                                    Tab{PanelTab::method, "Method", &Panel::draw_method},
                                    Tab{PanelTab::numbers, "Numbers", &Panel::draw_numbers}};
  if (!ImGui::BeginTabBar("tabs")) return;
  for (const Tab& tab : kTabs) {
    const int flags = wanted_tab_ == tab.tab ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
    const bool is_open = ImGui::BeginTabItem((translated(tab.label) + "##" + tab.label).c_str(), nullptr, flags);
    note(std::string("tab ").append(tab.label));
    if (!is_open) continue;
    ImGui::BeginChild(tab.label);  // scrolls below the tabs
    (this->*tab.draw)(demo);
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
}

/// The way back to a hidden panel for those who have only a mouse. It is at the left edge, where a page has no text, and
/// goes when the pointer rests.
void Panel::draw_handle(const PanelInput& input) {
  handle_left_ = input.mouse != pointer_ ? kHandleTime : handle_left_ - input.elapsed;
  pointer_ = input.mouse;
  if (handle_left_ <= 0) return;
  ImGui::SetNextWindowPos({0, 0.45f * static_cast<float>(sheet_.picture_height())}, ImGuiCond_Always, {0, 0.5f});
  ImGui::Begin("handle", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground);
  if (button("panel", "»")) is_shown = true;
  ImGui::End();
}

void Panel::hint(const std::string& text) {
  hint_ = text;
  hint_left_ = kHintTime;
}

void Panel::draw_hint(float elapsed) {
  hint_left_ -= elapsed;
  if (hint_left_ <= 0) return;
  const float beside =
      is_shown ? static_cast<float>(width_in(sheet_.picture_width(), sheet_.picture_height(), 1)) : 0.0f;
  const auto width = static_cast<float>(sheet_.picture_width()), height = static_cast<float>(sheet_.picture_height());
  if (top > 0) {  // captions are below
    ImGui::SetNextWindowPos({width - 12 * sheet_.unit(), top * height}, ImGuiCond_Always, {1, 0});
  } else {
    ImGui::SetNextWindowPos({0.5f * (beside + width), 0.97f * height}, ImGuiCond_Always, {0.5f, 1});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, std::min(hint_left_ / kFade, 1.0f));
  ImGui::Begin("hint", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextUnformatted(hint_.c_str());
  note("hint");
  ImGui::End();
  ImGui::PopStyleVar();
}

bool Panel::has_mouse() const {
  ImGui::SetCurrentContext(sheet_.context());
  return ImGui::GetIO().WantCaptureMouse;
}
bool Panel::has_keyboard() const {
  ImGui::SetCurrentContext(sheet_.context());
  return ImGui::GetIO().WantTextInput;
}

void Panel::heading(const char* title) {
  ImGui::Spacing();
  ImGui::TextDisabled("%s", translated(title).c_str());
  ImGui::Separator();
}

bool Panel::button(const std::string& name, const std::string& label) {
  const bool is_pressed = ImGui::Button((label + "##" + name).c_str());
  note(name);
  return is_pressed;
}

/// A drop-down list; `entries` calls entry() for each entry.
void Panel::combo(const std::string& name, const std::string& label, const std::string& current,
                  const std::function<void()>& entries) {
  const std::string title = place_label(name, label);
  const bool is_open = ImGui::BeginCombo(title.c_str(), current.c_str(), ImGuiComboFlags_HeightLarge);
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

/// A value beside its name; a long one takes more lines.
void Panel::row(const char* what, const std::string& value) {
  ImGui::TextUnformatted(translated(what).c_str());
  ImGui::SameLine(0.45f * ImGui::GetWindowContentRegionMax().x);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
  note(std::string("row ").append(what));
}

}  // namespace ballpit
