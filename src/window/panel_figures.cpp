// SPDX-License-Identifier: MIT
// The sections with figures: the picked sphere, cost, accuracy. Sections with controls: panel_sections.cpp.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "core/numbers.h"
#include "render/painter.h"
#include "window/panel.h"
#include "window/picked.h"

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
class Lengths {
 public:
  explicit Lengths(const Domain& domain) {
    double longest = 0;
    for (int axis = 0; axis < domain.dimensions; ++axis)
      longest = std::max(longest, domain.max[axis] - domain.min[axis]);
    has_millimetres_ = longest >= 0.1 && longest < 1e4;
  }

  std::string text(float length) const {
    return has_millimetres_ ? fmt::format("{:.3f}", length) : fmt::format("{:.4g}", length);
  }

 private:
  bool has_millimetres_;
};

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
  const Lengths lengths(demo.session.scene().domain);
  std::string place = lengths.text(p.x) + ", " + lengths.text(p.y);
  if (inspection.bodies.dimensions == 3) place += ", " + lengths.text(p.z);
  row("sphere", std::to_string(i));
  row("place", place + " m");
  row("touches", counted_numbers(partners_of(inspection.contacts, i)));
  draw_places(inspection, i);
  if (const auto interval = interval_of(inspection, i)) {
    const char axis = "xyz"[std::clamp(inspection.axis, 0, 2)];
    row("interval", fmt::format("{}: {} to {} m", axis, lengths.text(interval->begin), lengths.text(interval->end)));
    row("in the sorted list",
        fmt::format("entries {} and {} of {}", grouped(static_cast<int64_t>(interval->begin_place)),
                    grouped(static_cast<int64_t>(interval->end_place)),
                    grouped(static_cast<int64_t>(inspection.endpoints.size()))));
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
  row("energy", three_digits(report.kinetic_energy + report.potential_energy + report.elastic_energy) + " J");
  row("since its start", (now.energy_drift >= 0 ? "+" : "−") + scientific(std::fabs(double(now.energy_drift))));
  plot("drift", &history[0].energy_drift, history.size(), sizeof(Moment), FLT_MAX);
  row("largest overlap", scientific(report.max_overlap) + " r");
  plot("overlap", &history[0].max_overlap, history.size(), sizeof(Moment), 0);
  row("momentum", scientific(length(report.momentum)) + " kg·m/s");
}

}  // namespace ballpit
