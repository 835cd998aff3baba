// SPDX-License-Identifier: MIT
#include "window/panel.h"

#include <cmath>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "methods/methods.h"

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
  for (const ImGuiCol accent : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive,
                                ImGuiCol_PlotHistogram, ImGuiCol_PlotLines}) {
    style.Colors[accent] = im(theme.grid);
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
  io.DisplaySize = {static_cast<float>(sheet.picture_width()), static_cast<float>(sheet.height())};
  io.DeltaTime = std::max(input.elapsed, 1e-4f);
  io.MousePos = input.mouse.x > -1e5f ? ImVec2{input.mouse.x, input.mouse.y} : ImVec2{-FLT_MAX, -FLT_MAX};
  io.MouseDown[0] = input.is_down;
  io.MouseWheel = input.wheel;
  for (const auto& [key, is_down] : input.keys) {
    if (key >= 0 && key < 512) io.KeysDown[key] = is_down;
  }
  for (const char32_t character : input.typed) io.AddInputCharacter(character);
}

constexpr float kItemWidth = 0.58f;  // of the panel's; the rest is the label's

/// The smallest radius in units of 2·r_max, which is slide 7's bound for cells; and 2·r_max itself.
std::vector<SliderMark> marks_of(std::string_view setting, const BodyShape& bodies) {
  if (setting != "cell-size" || bodies.count == 0) return {};
  return {{0.5f * bodies.smallest / bodies.radius, bodies.smallest < bodies.radius ? "r_min" : "r"}, {1, "2·r_max"}};
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

void Panel::note(const std::string& name) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  items_[name] = {{low.x, low.y}, {high.x, high.y}};
  if (name == revealed_) ImGui::SetScrollHereY();
}

void Panel::draw(Demo& demo, const PanelInput& input) {
  ImGui::SetCurrentContext(sheet_.context());
  sheet_.scale_panel(demo.view.ui_scale, density);
  feed(ImGui::GetIO(), input, sheet_);
  style_for(theme_named(demo.view.theme), sheet_.unit() * demo.view.ui_scale);
  items_.clear();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  ImGui::SetNextWindowPos({0, 0});
  const auto width = static_cast<float>(width_in(sheet_.picture_width(), sheet_.height(), demo.view.ui_scale));
  ImGui::SetNextWindowSize({width, static_cast<float>(sheet_.height())});
  ImGui::Begin("Ballpit", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  draw_time(demo);
  const std::string& trouble = demo.player.failure().empty() ? demo.message() : demo.player.failure();
  if (!trouble.empty()) ImGui::TextWrapped("%s", trouble.c_str());
  draw_detection(demo);
  draw_view(demo);
  draw_picked(demo);
  draw_cost(demo);
  draw_accuracy(demo);
  draw_trade_off(demo);
  draw_response(demo);
  draw_export();
  ImGui::End();
  draw_keys(demo);
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  revealed_.clear();
}

bool Panel::has_mouse() const {
  ImGui::SetCurrentContext(sheet_.context());
  return ImGui::GetIO().WantCaptureMouse;
}
bool Panel::has_keyboard() const {
  ImGui::SetCurrentContext(sheet_.context());
  return ImGui::GetIO().WantTextInput;
}

/// A heading; returns whether the section below it is open.
bool Panel::section(const char* title) {
  const bool is_open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
  note(std::string("section ").append(title));
  return is_open;
}

bool Panel::button(const std::string& name, const std::string& label) {
  const bool is_pressed = ImGui::Button((label + "##" + name).c_str());
  note(name);
  return is_pressed;
}

/// A drop-down list; `entries` calls entry() for each entry.
void Panel::combo(const std::string& name, const std::string& label, const std::string& current,
                  const std::function<void()>& entries) {
  ImGui::SetNextItemWidth(kItemWidth * ImGui::GetContentRegionAvail().x);
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

/// Returns true once the slider is released, or a number was typed into it.
bool Panel::slider(const std::string& name, const std::string& label, float& value, const SliderLook& look) {
  const auto edited = edited_.find(name);
  float shown = edited != edited_.end() ? edited->second : value;
  const float width = kItemWidth * ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(width);
  const ImGuiSliderFlags flags = look.is_log ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
  if (ImGui::SliderFloat((label + "##" + name).c_str(), &shown, look.low, look.high, look.format, flags)) {
    edited_[name] = shown;
  }
  note(name);
  const bool is_released = ImGui::IsItemDeactivatedAfterEdit();
  draw_marks(look, width);
  if (!is_released) return false;
  value = shown;
  edited_.erase(name);
  return true;
}

/// Draws ticks with names on the slider that was drawn last, where ImGui centres the grab for these values.
void Panel::draw_marks(const SliderLook& look, float width) {
  if (look.marks.empty()) return;
  constexpr float kPadding = 2;  // ImGui's own, between frame and grab [pixel]
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float ends = kPadding + 0.5f * ImGui::GetStyle().GrabMinSize, names = high.y + 2 * sheet_.unit();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float free_from = low.x;  // so that names do not overlap
  for (const SliderMark& mark : look.marks) {
    if (mark.at < look.low || mark.at > look.high) continue;
    const float part = look.is_log ? std::log(mark.at / look.low) / std::log(look.high / look.low)
                                   : (mark.at - look.low) / (look.high - look.low);
    const float x = low.x + ends + part * (width - 2 * ends);
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    list.AddLine({x, low.y + 0.6f * (high.y - low.y)}, {x, names + 2}, color, std::max(2 * sheet_.unit(), 1.0f));
    const float size = ImGui::CalcTextSize(mark.name.c_str()).x, left = std::max(x - 0.5f * size, free_from);
    list.AddText({left, names}, color, mark.name.c_str());
    free_from = left + size + 0.4f * ImGui::GetFontSize();
  }
  ImGui::Dummy({width, ImGui::GetTextLineHeight()});
}

void Panel::number_setting(Demo& demo, const SettingInfo& info) {
  const std::string name(info.name);
  if (const auto& range = info.slider) {
    auto value = static_cast<float>(info.in_use(demo.session.settings()));
    const SliderLook look{range->low, range->high, range->is_log, range->is_integer ? "%.0f" : "%.4g",
                          marks_of(info.name, demo.session.world().shape())};
    if (slider(name, name, value, look)) {
      demo.set(name, range->is_integer ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value));
    }
  } else {
    std::string& text = typed_[name];
    if (text.empty()) text = info.get(demo.session.settings());
    ImGui::SetNextItemWidth(kItemWidth * ImGui::GetContentRegionAvail().x);
    const bool is_entered = ImGui::InputText((name + "##" + name).c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue);
    note(name);
    if (is_entered) demo.set(name, text);
    if (!ImGui::IsItemActive()) text.clear();
  }
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s: %s", std::string(info.help).c_str(), info.allowed.c_str());
}

/// A setting as its table describes it. Names that do not fit the response are not offered.
void Panel::setting(Demo& demo, const SettingInfo& info) {
  if (info.choices.empty()) {
    number_setting(demo, info);
    return;
  }
  const std::string name(info.name), current = info.get(demo.session.settings());
  combo(name, name, current, [&] {
    for (const std::string_view choice : info.choices) {
      if (info.name != "response" && !goes_with(demo.session.settings().response, info.name, choice)) continue;
      if (entry(name + " " + std::string(choice), std::string(choice), choice == current))
        demo.set(name, std::string(choice));
    }
  });
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(info.help).c_str());
}

/// A value beside its name; a long one takes more lines.
void Panel::row(const char* what, const std::string& value) {
  ImGui::TextUnformatted(what);
  ImGui::SameLine(0.45f * ImGui::GetWindowContentRegionMax().x);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
  note(std::string("row ").append(what));
}

}  // namespace ballpit
