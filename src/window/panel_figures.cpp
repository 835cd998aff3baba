// SPDX-License-Identifier: MIT
// The tab with figures: cost, accuracy, and the chart of one against the other.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "core/language.h"
#include "core/numbers.h"
#include "window/panel.h"

namespace ballpit {

namespace {

/// "+0.12 %": of a fraction.
std::string percent(double fraction, bool has_sign) {
  const std::string number = with_unit(100 * std::fabs(fraction)) + " %";
  return !has_sign ? number : (fraction >= 0 ? "+" : "−") + number;
}

constexpr double kMinCost = 1e-9;   // [s] a simulated second
constexpr double kMinError = 1e-9;  // smaller errors are drawn on the lower edge

/// A logarithmic axis from one power of ten to another.
struct LogAxis {
  int low, high;          // powers of ten
  float at_low, at_high;  // [pixel]

  float at(double value) const {
    const auto part = static_cast<float>((std::log10(value) - low) / (high - low));
    return at_low + std::clamp(part, 0.0f, 1.0f) * (at_high - at_low);
  }
};

/// An axis that holds all values, none smaller than `least`, and spans at least two powers of ten.
template <class Value>
LogAxis axis_of(const std::vector<Played>& trials, double least, const Value& value, float at_low, float at_high) {
  int low = 100, high = -100;
  for (const Played& trial : trials) {
    const double power = std::log10(std::max(value(trial), least));
    low = std::min(low, static_cast<int>(std::floor(power)));
    high = std::max(high, static_cast<int>(std::ceil(power)));
  }
  if (low > high) low = -3, high = 0;
  while (high < low + 2) (high - low) % 2 == 0 ? ++high : --low;
  return {low, high, at_low, at_high};
}

std::string power_of_ten(int power) {
  if (power < -3 || power > 3) return fmt::format("1e{}", power);
  return local_number(fmt::format("{:.{}f}", std::pow(10.0, power), std::max(-power, 0)));
}

void dotted(ImDrawList& lines, ImVec2 from, ImVec2 to, ImU32 color, float unit) {
  const float length = std::hypot(to.x - from.x, to.y - from.y), step = 6 * unit;
  for (float at = 0; at < length; at += step) {
    const float a = at / length, b = std::min(at + step / 2, length) / length;
    lines.AddLine({from.x + a * (to.x - from.x), from.y + a * (to.y - from.y)},
                  {from.x + b * (to.x - from.x), from.y + b * (to.y - from.y)}, color, 2 * unit);
  }
}

}  // namespace

/// A curve below the present figure, as wide as the panel.
void Panel::plot(const char* name, const float* values, size_t count, int stride, float from) {
  const ImVec2 size{ImGui::GetContentRegionAvail().x, 2.6f * ImGui::GetTextLineHeight()};
  const std::string label = std::string("##").append(name);
  ImGui::PlotLines(label.c_str(), values, static_cast<int>(count), 0, nullptr, from, FLT_MAX, size, stride);
  note(name);
}

void Panel::draw_numbers(Demo& demo) {
  heading("Cost");
  const Report& report = demo.report();
  const std::vector<float> times(demo.player.step_times().begin(), demo.player.step_times().end());
  row("spheres", grouped(report.count));
  const bool is_played = !times.empty();
  const double mean =
      is_played ? 1e-3 * demo.player.mean_step_time() : report.seconds / double(std::max<int64_t>(report.steps, 1));
  row("a step", with_unit(mean, "s"));
  if (is_played) plot("times", times.data(), times.size(), sizeof(float), 0);
  row("candidates", grouped(report.candidates));
  row("contacts", grouped(report.contacts));
  if (demo.view.shows("pairs")) row("missed", grouped(static_cast<int64_t>(demo.inspection().missed.size())));
  row("by", report.broadphase + ", " + demo.session.backend());
  heading("Accuracy");
  const std::vector<Moment>& history = demo.history();
  const Moment& now = history.back();
  row("energy", with_unit(energy_of(report), "J"));
  row("since its start", percent(double(now.energy_drift), true));
  plot("drift", &history[0].energy_drift, history.size(), sizeof(Moment), FLT_MAX);
  row("largest overlap", percent(report.max_overlap, false) + " r");
  plot("overlap", &history[0].max_overlap, history.size(), sizeof(Moment), 0);
  row("momentum", with_unit(length(report.momentum)) + " kg·m/s");
  draw_ghost(demo);
  heading("Speed against accuracy");
  draw_trade_off(demo);
  heading("Stages of a step");
  double sum = 0;
  for (const Stage& stage : report.stages) sum += stage.seconds;
  for (const Stage& stage : report.stages) {
    const auto part = static_cast<float>(stage.seconds / std::max(sum, 1e-12));
    if (part >= 0.05f) ImGui::ProgressBar(part, {ImGui::GetContentRegionAvail().x, 0}, stage.name.c_str());
  }
}

/// A point for each trial, filled for the present one, the front as a line, and a diamond for what a choice expects.
void Panel::draw_trade_off(Demo& demo) {
  const auto errors = played_errors();
  for (size_t k = 0; k < errors.size(); ++k) {
    if (ImGui::RadioButton(translated(errors[k].label).c_str(), k == charted_error_)) charted_error_ = k;
    note("error " + std::string(errors[k].name));
  }
  const PlayedError& error = errors[charted_error_];
  const std::vector<Played>& trials = demo.trade_off.trials();
  const std::optional<Played>& prediction = demo.trade_off.prediction;
  std::vector<Played> shown;
  std::ranges::copy_if(trials, std::back_inserter(shown), [](const Played& trial) { return trial.steps > 0; });
  if (prediction) shown.push_back(*prediction);
  const float unit = sheet_.unit(), text = ImGui::GetTextLineHeight(), margin = 3.2f * text;
  const ImVec2 low = ImGui::GetCursorScreenPos(),
               size{std::max(ImGui::GetContentRegionAvail().x, 1.0f), (prediction ? 12.2f : 11) * text};
  const ImVec2 inner_low{low.x + margin, low.y + text / 2}, inner_high{low.x + size.x - text, low.y + 8.6f * text};
  ImGui::InvisibleButton("##trade-off", size);
  const bool is_clicked = ImGui::IsItemClicked();
  note("trade-off");
  if (revealed_.rfind("trial ", 0) == 0) ImGui::SetScrollHereY();

  const LogAxis x = axis_of(
      shown, kMinCost, [](const Played& t) { return t.cost(); }, inner_low.x, inner_high.x);
  const LogAxis y = axis_of(
      shown, kMinError, [&](const Played& t) { return t.*error.value; }, inner_high.y, inner_low.y);
  ImDrawList& lines = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text), faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const auto right_of = [&](const std::string& label, float at_x, float at_y, ImU32 color) {
    lines.AddText({at_x - ImGui::CalcTextSize(label.c_str()).x, at_y}, color, label.c_str());
  };
  lines.AddRect(inner_low, inner_high, faint, 0, 0, unit);
  for (const int power : {x.low, x.high}) {
    const std::string label = power_of_ten(power);
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    lines.AddText({x.at(std::pow(10.0, power)) - (power == x.high ? width : 0), inner_high.y + text / 5}, ink,
                  label.c_str());
  }
  for (const int power : {y.low, y.high})
    right_of(power_of_ten(power), inner_low.x - text / 4, y.at(std::pow(10.0, power)) - (power == y.low ? text : 0),
             ink);
  const std::string what = translated("s computed for a second simulated");
  lines.AddText({inner_low.x, inner_high.y + 1.3f * text}, faint, what.c_str());
  if (x.low < 0 && 0 < x.high) {
    dotted(lines, {x.at(1), inner_low.y}, {x.at(1), inner_high.y}, faint, unit);
    right_of(translated("real time"), x.at(1) - text / 4, inner_low.y + text / 5, faint);
  }

  const auto place = [&](const Played& t) {
    return ImVec2{x.at(std::max(t.cost(), kMinCost)), y.at(std::max(t.*error.value, kMinError))};
  };
  std::vector<ImVec2> front;
  for (const int k : demo.trade_off.front(error)) front.push_back(place(trials[static_cast<size_t>(k)]));
  lines.AddPolyline(front.data(), static_cast<int>(front.size()), faint, 0, 2 * unit);
  const float radius = 6 * unit, reach = 2 * radius;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Played* chosen = nullptr;
  if (prediction) {
    const ImVec2 at = place(*prediction);
    draw_prediction({at.x, at.y}, {inner_low.x, inner_high.y + 2.5f * text});
    if (std::hypot(mouse.x - at.x, mouse.y - at.y) <= reach) chosen = &*prediction;
  }
  for (size_t k = 0; k < trials.size(); ++k) {
    if (trials[k].steps == 0) continue;
    const ImVec2 at = place(trials[k]);
    const bool is_current = static_cast<int>(k) == demo.trade_off.current();
    if (is_current) lines.AddCircleFilled(at, radius, ink);
    lines.AddCircle(at, radius, ink, 0, 2 * unit);
    items_["trial " + std::to_string(k)] = {{at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}};
    if (std::hypot(mouse.x - at.x, mouse.y - at.y) <= reach) chosen = &trials[k];
  }
  if (chosen) {
    ImGui::SetTooltip("%s\n%s, %s %s", chosen->label().c_str(), with_unit(chosen->cost(), "s/s").c_str(),
                      translated("error").c_str(), with_unit(chosen->*error.value).c_str());
  }
  if (is_clicked && chosen) demo.return_to(*chosen);
}

}  // namespace ballpit
