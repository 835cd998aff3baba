// SPDX-License-Identifier: MIT
// The panel's sections that tell: the picked sphere, cost, accuracy.
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>

#include <imgui.h>

#include "core/numbers.h"
#include "render/painter.h"
#include "window/panel.h"
#include "window/picked.h"

namespace ballpit {

namespace {

std::string scientific(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}

/// "3: 4, 7, 9"; of many the first ones.
std::string numbers(const std::vector<int32_t>& bodies, const char* separator = ", ") {
  constexpr size_t kMost = 12;
  std::string text;
  for (size_t k = 0; k < std::min(bodies.size(), kMost); ++k) {
    if (k > 0) text.append(separator);
    text.append(std::to_string(bodies[k]));
  }
  if (bodies.size() > kMost) text.append(separator).append("…");
  return text;
}

std::string counted_numbers(const std::vector<int32_t>& bodies) {
  if (bodies.empty()) return "none";
  return grouped(static_cast<int64_t>(bodies.size())).append(": ").append(numbers(bodies));
}

/// "0.250 m": to a millimetre in a domain of about a metre, to four digits where lengths are far from that.
class Lengths {
 public:
  explicit Lengths(const Domain& domain) {
    double longest = 0;
    for (int axis = 0; axis < domain.dimensions; ++axis)
      longest = std::max(longest, domain.max[axis] - domain.min[axis]);
    format_ = longest >= 0.1 && longest < 1e4 ? "%.3f" : "%.4g";
  }

  std::string text(float length) const {
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), format_, double(length));
    return text.data();
  }

 private:
  const char* format_;
};

}  // namespace

/// A history below the present figure, which says what it is of; as wide as the panel.
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
  const Lengths lengths(demo.session.scene().domain);
  std::string place = lengths.text(p.x) + ", " + lengths.text(p.y);
  if (inspection.bodies.dimensions == 3) place += ", " + lengths.text(p.z);
  row("sphere", std::to_string(i));
  row("place", place + " m");
  row("touches", counted_numbers(partners_of(inspection.contacts, i)));
  draw_places(inspection, i);
  if (const auto interval = interval_of(inspection, i)) {
    const std::string axis(1, "xyz"[std::clamp(inspection.axis, 0, 2)]);
    row("interval", axis + ": " + lengths.text(interval->begin) + " to " + lengths.text(interval->end) + " m");
    row("in the sorted list", "entries " + grouped(static_cast<int64_t>(interval->begin_place)) + " and " +
                                  grouped(static_cast<int64_t>(interval->end_place)) + " of " +
                                  grouped(static_cast<int64_t>(inspection.endpoints.size())));
  }
  if (!demo.has_candidates()) {
    row("candidates", "too many pairs to look through");
  } else {
    row("candidates", counted_numbers(partners_of(inspection.candidates, i)));
  }
}

/// The cell whose list or range holds it.
void Panel::draw_places(const Inspection& inspection, int32_t body) {
  if (const auto listed = listed_in(inspection, body)) {
    const IVec3& c = listed->cell;
    std::string cell = std::to_string(listed->index) + " at (" + std::to_string(c.x) + ", " + std::to_string(c.y);
    if (inspection.bodies.dimensions == 3) cell.append(", ").append(std::to_string(c.z));
    row("cell", cell.append(")"));
    row(listed->is_sorted ? "its range" : "its list", numbers(listed->bodies, listed->is_sorted ? ", " : " > "));
    row("place in it", std::to_string(listed->place + 1) + " of " + std::to_string(listed->bodies.size()));
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
  row("energy", three_digits(report.kinetic_energy + report.potential_energy + report.elastic_energy) + " J");
  row("since its start", (now.energy_drift >= 0 ? "+" : "−") + scientific(std::fabs(double(now.energy_drift))));
  plot("drift", &history[0].energy_drift, history.size(), sizeof(Moment), FLT_MAX);
  row("largest overlap", scientific(report.max_overlap) + " r");
  plot("overlap", &history[0].max_overlap, history.size(), sizeof(Moment), 0);
  row("momentum", scientific(length(report.momentum)) + " kg·m/s");
}

}  // namespace ballpit
