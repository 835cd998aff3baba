// SPDX-License-Identifier: MIT
// The sections with figures: the picked sphere, cost, accuracy, and the chart of speed against accuracy. Sections with
// controls: panel_sections.cpp.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "render/overlays/overlay.h"
#include "window/panel.h"

namespace ballpit {

namespace {

std::string scientific(double value) { return fmt::format("{:.2g}", value); }

/// "4, 7, 9"; only the first of many.
std::string numbers(const std::vector<int32_t>& bodies, const char* separator = ", ") {
  constexpr size_t kMax = 12;
  const auto end = bodies.begin() + static_cast<std::ptrdiff_t>(std::min(bodies.size(), kMax));
  const std::string text = fmt::format("{}", fmt::join(bodies.begin(), end, separator));
  return bodies.size() > kMax ? fmt::format("{}{}…", text, separator) : text;
}

/// "3: 4, 7, 9".
std::string counted_numbers(const std::vector<int32_t>& bodies) {
  if (bodies.empty()) return "none";
  return fmt::format("{}: {}", grouped(static_cast<int64_t>(bodies.size())), numbers(bodies));
}

/// "0.250": with millimetres in a domain of about a metre, with four digits in much smaller or larger ones.
std::string length_text(const Domain& domain, float length) {
  const Vec3d size = domain.max - domain.min;
  const double longest = std::max({size.x, size.y, size.z});
  return longest >= 0.1 && longest < 1e4 ? fmt::format("{:.3f}", length) : fmt::format("{:.4g}", length);
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
    if (trial.steps == 0) continue;
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
  return fmt::format("{:.{}f}", std::pow(10.0, power), std::max(-power, 0));
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

void Panel::draw_picked(Demo& demo) {
  const auto i = static_cast<int32_t>(demo.view.selected);
  if (i < 0) return;
  const Inspection& inspection = demo.inspection();
  if (i >= inspection.bodies.count) return;
  if (!section("Picked sphere")) return;
  const Vec3 p = inspection.bodies.position_of(i);
  const auto metres = [&](float length) { return length_text(demo.session.scene().domain, length); };
  std::string place = metres(p.x) + ", " + metres(p.y);
  if (inspection.bodies.dimensions == 3) place += ", " + metres(p.z);
  row("sphere", std::to_string(i));
  row("place", place + " m");
  row("touches", counted_numbers(touching(inspection, i)));
  if (const auto missed = partners_of(inspection.missed, i); !missed.empty()) row("missed", counted_numbers(missed));
  draw_places(inspection, i);
  const std::vector<Endpoint>& ends = inspection.endpoints;
  if (const Walk walk = shown_walk(ends, i); walk.body >= 0) {
    const char axis = "xyz"[std::clamp(inspection.axis, 0, 2)];
    row("interval", fmt::format("{}: {} to {} m", axis, metres(ends[walk.first].at), metres(ends[walk.last].at)));
    const auto number = [](size_t k) { return grouped(static_cast<int64_t>(k)); };
    row("in the sorted list",
        fmt::format("entries {} and {} of {}", number(walk.first), number(walk.last), number(ends.size())));
  }
  if (!demo.has_candidates()) {
    row("candidates", "too many pairs to look through");
  } else {
    row("candidates", counted_numbers(partners_of(inspection.candidates, i)));
  }
}

/// The cell whose list or range holds the sphere.
void Panel::draw_places(const Inspection& inspection, int32_t body) {
  if (const auto listed = listed_in(inspection, body)) {
    const IVec3& c = listed->cell;
    const std::string z = inspection.bodies.dimensions == 3 ? fmt::format(", {}", c.z) : "";
    row("cell", fmt::format("{} at ({}, {}{})", listed->index, c.x, c.y, z));
    row(listed->is_sorted ? "its range" : "its list", numbers(listed->bodies, listed->is_sorted ? ", " : " > "));
    row("place in it", fmt::format("{} of {}", listed->place + 1, listed->bodies.size()));
  }
}

void Panel::draw_cost(Demo& demo) {
  if (!section("Cost")) return;
  const Report& report = demo.report();
  const std::vector<float> times(demo.player.step_times().begin(), demo.player.step_times().end());
  row("spheres", grouped(report.count));
  const bool is_played = !times.empty();
  const double mean =
      is_played ? demo.player.mean_step_time() : 1e3 * report.seconds / double(std::max<int64_t>(report.steps, 1));
  row("a step", three_digits(mean) + " ms");
  if (is_played) plot("times", times.data(), times.size(), sizeof(float), 0);
  row("candidates", grouped(report.candidates));
  row("contacts", grouped(report.contacts));
  if (demo.view.shows("pairs")) row("missed", grouped(static_cast<int64_t>(demo.inspection().missed.size())));
  row("by", report.broadphase + ", " + demo.session.backend());
  double sum = 0;
  for (const Stage& stage : report.stages) sum += stage.seconds;
  for (const Stage& stage : report.stages) {
    const auto part = static_cast<float>(stage.seconds / std::max(sum, 1e-12));
    if (part >= 0.05f) ImGui::ProgressBar(part, {ImGui::GetContentRegionAvail().x, 0}, stage.name.c_str());
  }
}

void Panel::draw_accuracy(Demo& demo) {
  if (!section("Accuracy")) return;
  const Report& report = demo.report();
  const std::vector<Moment>& history = demo.history();
  const Moment& now = history.back();
  row("energy", three_digits(energy_of(report)) + " J");
  row("since its start", (now.energy_drift >= 0 ? "+" : "−") + scientific(std::fabs(double(now.energy_drift))));
  plot("drift", &history[0].energy_drift, history.size(), sizeof(Moment), FLT_MAX);
  row("largest overlap", scientific(report.max_overlap) + " r");
  plot("overlap", &history[0].max_overlap, history.size(), sizeof(Moment), 0);
  row("momentum", scientific(length(report.momentum)) + " kg·m/s");
}

/// A point for each trial, filled for the present one, and the front as a line.
void Panel::draw_trade_off(Demo& demo) {
  if (!section("Speed against accuracy")) return;
  const auto errors = played_errors();
  for (size_t k = 0; k < errors.size(); ++k) {
    if (ImGui::RadioButton(std::string(errors[k].label).c_str(), k == charted_error_)) charted_error_ = k;
    note("error " + std::string(errors[k].name));
  }
  const PlayedError& error = errors[charted_error_];
  const std::vector<Played>& trials = demo.trade_off.trials();
  const float unit = sheet_.unit(), text = ImGui::GetTextLineHeight(), margin = 3.2f * text;
  const ImVec2 low = ImGui::GetCursorScreenPos(), size{std::max(ImGui::GetContentRegionAvail().x, 1.0f), 11 * text};
  const ImVec2 inner_low{low.x + margin, low.y + text / 2},
      inner_high{low.x + size.x - text, low.y + size.y - 2.4f * text};
  ImGui::InvisibleButton("##trade-off", size);
  const bool is_clicked = ImGui::IsItemClicked();
  note("trade-off");
  if (revealed_.rfind("trial ", 0) == 0) ImGui::SetScrollHereY();

  const LogAxis x = axis_of(
      trials, kMinCost, [](const Played& t) { return t.cost(); }, inner_low.x, inner_high.x);
  const LogAxis y = axis_of(
      trials, kMinError, [&](const Played& t) { return t.*error.value; }, inner_high.y, inner_low.y);
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
  const std::string what = "s computed for a second simulated";
  lines.AddText({inner_low.x, inner_high.y + 1.3f * text}, faint, what.c_str());
  if (x.low < 0 && 0 < x.high) {
    dotted(lines, {x.at(1), inner_low.y}, {x.at(1), inner_high.y}, faint, unit);
    right_of("real time", x.at(1) - text / 4, inner_low.y + text / 5, faint);
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
  for (size_t k = 0; k < trials.size(); ++k) {
    if (trials[k].steps == 0) continue;
    const ImVec2 at = place(trials[k]);
    const bool is_current = static_cast<int>(k) == demo.trade_off.current();
    if (is_current) lines.AddCircleFilled(at, radius, ink);
    lines.AddCircle(at, radius, ink, 0, 2 * unit);
    items_["trial " + std::to_string(k)] = {{at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}};
    if (std::hypot(mouse.x - at.x, mouse.y - at.y) > reach) continue;
    chosen = &trials[k];
    ImGui::SetTooltip("%s\n%s s a simulated second, error %s", trials[k].label().c_str(),
                      three_digits(trials[k].cost()).c_str(), three_digits(trials[k].*error.value).c_str());
  }
  if (is_clicked && chosen) demo.return_to(*chosen);
}

}  // namespace ballpit
