// SPDX-License-Identifier: MIT
// The distance from exact motion in the tab with figures: the same chart as in the picture, at the panel's width.
#include <cmath>

#include <imgui.h>

#include "core/language.h"
#include "core/numbers.h"
#include "render/ghost_chart.h"
#include "window/panel.h"

namespace ballpit {

void Panel::draw_ghost(Demo& demo) {
  if (!demo.view.shows("ghost") || !demo.inspection().ghost) return;
  const GhostInspection& ghost = *demo.inspection().ghost;
  heading("Exact ghost");
  if (!ghost.lack.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(translated(ghost.lack).c_str());
    ImGui::PopTextWrapPos();
  }
  const bool has_past = ghost.curve.size() > 1;
  if (!has_past && !ghost.lack.empty()) return;
  const auto radii = [](double distance) { return distance > 0 ? with_unit(distance) + " r" : "0 r"; };
  row("median distance", radii(ghost.curve.back().median));
  row("largest distance", radii(ghost.curve.back().largest));
  if (ghost.growth > 0) row("Lyapunov's exponent", with_unit(ghost.growth) + " /s");
  if (ghost.wrong) {
    row("first wrong collision",
        time_text(ghost.wrong->time) + ", " + bodies_text(*ghost.wrong) + ", " + timing_text(*ghost.wrong));
  }
  if (has_past) draw_ghost_chart(chart_of(ghost), demo.view.theme);
}

void Panel::draw_ghost_chart(const GhostChart& chart, const std::string& theme_name) {
  const Theme& theme = theme_named(theme_name);
  const float unit = sheet_.unit(), text = ImGui::GetTextLineHeight(), margin = 3.2f * text;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 1.0f), 9 * text};
  ImGui::InvisibleButton("##ghost-curve", size);
  note("ghost curve");
  const ImVec2 low{corner.x + margin, corner.y + text / 2},
      high{corner.x + size.x - text, corner.y + size.y - 1.4f * text};
  const auto at = [&](const Vec2& p) {
    return ImVec2{low.x + p.x * (high.x - low.x), high.y - p.y * (high.y - low.y)};
  };
  ImDrawList& lines = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text), grey = to_rgba(theme.reference);
  const auto label = [&](const std::string& what, ImVec2 place, bool is_right) {
    const float width = is_right ? ImGui::CalcTextSize(what.c_str()).x : 0;
    lines.AddText({place.x - width, place.y}, ink, what.c_str());
  };
  lines.AddRect(low, high, grey, 0, 0, unit);
  for (const int power : {chart.low, chart.high}) {
    const float y = at({0, chart.height_of(std::pow(10.0, power))}).y;
    label(ten_to_the(power), {low.x - text / 4, power == chart.low ? y - text : y}, true);
  }
  label(time_text(chart.from), {low.x, high.y + text / 5}, false);
  if (chart.to > chart.from) label(time_text(chart.to), {high.x, high.y + text / 5}, true);
  if (chart.wrong) {
    const float x = at({*chart.wrong, 0}).x;
    for (const float side : {-2.5f, 2.5f}) {
      lines.AddLine({x + side * unit, low.y}, {x + side * unit, high.y}, to_rgba(theme.missed), 2 * unit);
    }
  }
  if (chart.growth) {
    const ImVec2 from = at((*chart.growth)[0]), to = at((*chart.growth)[1]);
    const int dots = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / (8 * unit));
    for (int k = 0; k <= dots; ++k) {
      const float part = dots > 0 ? static_cast<float>(k) / static_cast<float>(dots) : 0;
      lines.AddCircleFilled({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)}, 2 * unit, grey);
    }
  }
  const auto curve = [&](const std::vector<Vec2>& points, float width) {
    std::vector<ImVec2> places;
    for (const Vec2& point : points) places.push_back(at(point));
    lines.AddPolyline(places.data(), static_cast<int>(places.size()), ink, 0, width);
  };
  curve(chart.largest, 1.5f * unit);
  curve(chart.median, 3.5f * unit);
}

}  // namespace ballpit
