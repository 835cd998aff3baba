// SPDX-License-Identifier: MIT
// Settings as sliders, lists and fields, as their table describes them.
#include <cmath>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "core/language.h"
#include "core/numbers.h"
#include "methods/methods.h"
#include "window/panel.h"

namespace ballpit {

namespace {

/// The value on a slider: one of its snaps if that is near, else one with few digits.
float snapped(const SliderLook& look, float value) {
  constexpr float kNear = 0.03f;  // of the slider's length
  const auto part_of = [&](float at) {
    return look.is_log ? std::log(at / look.low) / std::log(look.high / look.low)
                       : (at - look.low) / (look.high - look.low);
  };
  for (const float snap : look.snaps) {
    if (std::fabs(part_of(value) - part_of(snap)) < kNear) return snap;
  }
  if (look.is_integer) return std::round(value);
  if (!look.is_log) {
    const float step = (look.high - look.low) / 100;
    return look.low + step * std::round((value - look.low) / step);
  }
  const float power = std::pow(10.0f, std::floor(std::log10(value)) - 1);
  return power * std::round(value / power);
}

/// The smallest radius in units of 2·r_max, which is slide 7's bound for cells; and 2·r_max itself.
std::vector<SliderMark> marks_of(std::string_view setting, const BodyShape& bodies) {
  if (setting != "cell-size" || bodies.count == 0) return {};
  return {{0.5f * bodies.smallest / bodies.radius, bodies.smallest < bodies.radius ? "r_min" : "r"}, {1, "2·r_max"}};
}

}  // namespace

std::string shown_value(const SettingInfo& info, double value, const BodyShape& bodies) {
  const std::string number = local_number(fmt::format("{:.3g}", value));
  if (info.name == "cell-size") {
    const char* const diameter = bodies.smallest < bodies.radius ? "2r_max" : "2r";
    return fmt::format("{} × {} = {}", number, diameter, with_unit(2 * value * double(bodies.radius), "m", true));
  }
  if (info.name == "threads" && value == 0) {
    return fmt::format("{} ({})", translated("all"), std::thread::hardware_concurrency());
  }
  if (info.name == "dt") return with_unit(value, "s", true);
  if (info.name == "compliance") return with_unit(value, "m/N", true);
  if (info.name == "skin") return number + " r";
  return number;
}

/// Returns true whenever the value changes: while the slider is dragged, or once a number was typed into it.
bool Panel::slider(const std::string& name, const std::string& label, float& value, const SliderLook& look) {
  const std::string title = place_label(name, label);
  const float width = ImGui::CalcItemWidth();
  const auto edited = edited_.find(name);
  float shown = edited != edited_.end() ? edited->second : value;
  const bool is_typed = ImGui::GetIO().KeyCtrl || ImGui::TempInputIsActive(ImGui::GetID(title.c_str()));
  const ImGuiSliderFlags flags = look.is_log ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
  const std::string format = is_typed ? "%.6g" : look.shown;
  const bool is_moved = ImGui::SliderFloat(title.c_str(), &shown, look.low, look.high, format.c_str(), flags);
  note(name);
  const bool is_entered = ImGui::IsItemDeactivatedAfterEdit();
  draw_marks(look, width);
  const bool waits = is_typed || look.is_late;
  if (is_moved && waits) edited_[name] = is_typed ? shown : snapped(look, shown);
  if (is_entered && edited_.erase(name) > 0) {
    value = is_typed ? shown : snapped(look, shown);
    return true;
  }
  if (!is_moved || waits) return false;
  const float at = snapped(look, shown);
  return std::exchange(value, at) != at;
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
    const BodyShape bodies = demo.session.world().shape();
    const SliderLook look{.low = range->low,
                          .high = range->high,
                          .is_log = range->is_log,
                          .is_integer = range->is_integer,
                          .shown = shown_value(info, value, bodies),
                          .snaps = range->snaps,
                          .marks = marks_of(info.name, bodies)};
    if (slider(name, name, value, look)) {
      demo.set(name, range->is_integer ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value));
    }
  } else {
    std::string& text = typed_[name];
    if (text.empty()) text = info.get(demo.session.settings());
    const std::string title = place_label(name, name);
    const bool is_entered = ImGui::InputText(title.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue);
    note(name);
    if (is_entered) demo.set(name, text);
    if (!ImGui::IsItemActive()) text.clear();
  }
}

/// A setting as its table describes it. Names that do not fit the response are not offered.
void Panel::setting(Demo& demo, const SettingInfo& info) {
  if (info.choices.empty()) {
    number_setting(demo, info);
  } else {
    const std::string name(info.name), current = info.get(demo.session.settings());
    combo(name, name, current, [&] {
      for (const std::string_view choice : info.choices) {
        if (name == "response" && choice == name_of(Response::automatic)) continue;  // a button, since it takes long
        if (info.name != "response" && !goes_with(demo.session.settings().response, info.name, choice)) continue;
        if (entry(name + " " + std::string(choice), std::string(choice), choice == current))
          demo.set(name, std::string(choice));
      }
    });
  }
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::SetTooltip("%s%s", translated(info.help).c_str(), info.choices.empty() ? (": " + info.allowed).c_str() : "");
}

/// The settings of a group. Those that `method` does not use are grey, so that none moves when the method changes.
void Panel::settings(Demo& demo, SettingGroup group, const Method& method) {
  for (const SettingInfo& info : setting_table()) {
    if (info.group != group || info.name == "broadphase") continue;
    const bool is_common = group == SettingGroup::time || info.name == "response" || info.name == "skin" ||
                           info.name == "backend" || info.name == "threads";
    ImGui::BeginDisabled(!is_common && !uses(method, info.name));
    setting(demo, info);
    ImGui::EndDisabled();
  }
}

}  // namespace ballpit
