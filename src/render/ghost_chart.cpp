// SPDX-License-Identifier: MIT
#include "render/ghost_chart.h"

#include <algorithm>
#include <cmath>

#include "core/numbers.h"
#include "core/phrase.h"

namespace ballpit {

namespace {

constexpr int kLowest = -16, kMinDecades = 3;  // rounding of double precision; of the axis

void set_range(GhostChart& chart, const std::vector<GhostDistance>& curve) {
  double least = INFINITY, most = 1;
  for (const GhostDistance& d : curve) {
    for (const double value : {d.median, d.largest}) {
      if (value > 0) least = std::min(least, value);
      if (std::isfinite(value)) most = std::max(most, value);
    }
  }
  chart.high = static_cast<int>(std::ceil(std::log10(most)));
  chart.low = chart.high - kMinDecades;
  if (std::isfinite(least)) {
    chart.low = std::clamp(static_cast<int>(std::floor(std::log10(least))), kLowest, chart.low);
  }
}

/// The growth from the median at `ghost.growth_from`, up to the top or to the right end.
void add_growth(GhostChart& chart, const GhostInspection& ghost) {
  const std::vector<GhostDistance>& curve = ghost.curve;
  const auto after = std::find_if(curve.begin(), curve.end(),
                                  [&](const GhostDistance& d) { return d.time >= ghost.growth_from && d.median > 0; });
  if (!(ghost.growth > 0) || after == curve.end()) return;
  const double room = chart.high * std::log(10.0) - std::log(after->median);  // e-folds to the top
  const double wait = std::min(room / ghost.growth, chart.to - after->time), span = chart.to - chart.from;
  if (!(wait > 0)) return;
  const double end = after->median * std::exp(ghost.growth * wait);
  const auto x = [&](double time) { return static_cast<float>((time - chart.from) / span); };
  chart.growth = {{{x(after->time), chart.height_of(after->median)}, {x(after->time + wait), chart.height_of(end)}}};
}

}  // namespace

float GhostChart::height_of(double distance) const {
  if (!(distance > 0)) return 0;
  return static_cast<float>(std::clamp((std::log10(distance) - low) / (high - low), 0.0, 1.0));
}

GhostChart chart_of(const GhostInspection& ghost) {
  GhostChart chart;
  const std::vector<GhostDistance>& curve = ghost.curve;
  chart.from = chart.to = ghost.dropped;
  if (curve.size() < 2) return chart;
  chart.to = curve.back().time;
  set_range(chart, curve);
  const auto x = [&](double time) { return static_cast<float>((time - chart.from) / (chart.to - chart.from)); };
  for (const GhostDistance& d : curve) {
    const bool has_median = d.median > 0 || !chart.median.empty();
    const bool has_largest = d.largest > 0 || !chart.largest.empty();
    if (has_median) chart.median.emplace_back(x(d.time), chart.height_of(d.median));
    if (has_largest) chart.largest.emplace_back(x(d.time), chart.height_of(d.largest));
  }
  add_growth(chart, ghost);
  if (ghost.wrong) chart.wrong = std::clamp(x(ghost.wrong->time), 0.0f, 1.0f);
  return chart;
}

std::string timing_text(const WrongCollision& wrong) {
  const std::string by = with_unit(std::fabs(wrong.late_by), "s");
  switch (wrong.timing) {
    case Timing::open:
      return translated("has not come yet");
    case Timing::late:
      return phrase("late by {}", by);
    case Timing::early:
      return phrase("early by {}", by);
    case Timing::missed:
      return translated("never came");
  }
  return "";
}

std::string bodies_text(const WrongCollision& wrong) {
  if (wrong.partner < 0) return phrase("sphere {} and a wall", wrong.body);
  return phrase("spheres {} and {}", std::min(wrong.body, wrong.partner), std::max(wrong.body, wrong.partner));
}

std::string time_text(double time) {
  constexpr double kShort = 0.01;
  const bool is_short = time != 0 && std::fabs(time) < kShort;
  return "t = " + (is_short ? with_unit(time, "s") : local_number(fmt::format("{:.4g} s", time)));
}

}  // namespace ballpit
