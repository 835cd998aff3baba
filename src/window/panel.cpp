// SPDX-License-Identifier: MIT
#include "window/panel.h"

#include <algorithm>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

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
  io.KeyMap[ImGuiKey_Tab] = 258;
  io.KeyMap[ImGuiKey_LeftArrow] = 263;
  io.KeyMap[ImGuiKey_RightArrow] = 262;
  io.KeyMap[ImGuiKey_UpArrow] = 265;
  io.KeyMap[ImGuiKey_DownArrow] = 264;
  io.KeyMap[ImGuiKey_Home] = 268;
  io.KeyMap[ImGuiKey_End] = 269;
  io.KeyMap[ImGuiKey_Delete] = 261;
  io.KeyMap[ImGuiKey_Backspace] = 259;
  io.KeyMap[ImGuiKey_Enter] = 257;
  io.KeyMap[ImGuiKey_KeyPadEnter] = 335;
  io.KeyMap[ImGuiKey_Escape] = 256;
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

}  // namespace ballpit
