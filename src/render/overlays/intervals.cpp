// SPDX-License-Identifier: MIT
#include "render/overlays/intervals.h"

#include <algorithm>
#include <array>
#include <optional>

#include "broad_phase/inspection.h"
#include "render/overlays/interval_list.h"
#include "render/overlays/sweep_axis.h"
#include "render/painter.h"
#include "world/inspection.h"

namespace ballpit {

namespace {

constexpr float kBracket = 16, kSerif = 8, kLabels = 20;  // on the axis [1/1080 of the picture's height]
constexpr float kRows = 3;                                // of labels

/// A bracket at the endpoint: [ filled, ] hollow.
void draw_bracket(const Endpoint& endpoint, const SweepAxis& axis, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const Rgba color = to_rgba(painter.theme.begin);
  const Vec2 up = kBracket * u * axis.outward(), at = axis.at(endpoint.at);
  const Vec2 serif = (endpoint.is_end ? -kSerif : kSerif) * u * axis.along();
  const float width = (endpoint.is_end ? 3 : 5) * u;
  sheet.line(at - up, at + up, color, width);
  for (const Vec2& end : {at - up, at + up}) sheet.line(end, end + serif, color, width);
  if (!endpoint.is_end) sheet.line(at + 0.5f * serif - up, at + 0.5f * serif + up, color, kSerif * u);
}

/// For many spheres: begins point towards the scene, ends away from it; one tick per pixel.
void draw_ticks(const std::vector<Endpoint>& endpoints, const SweepAxis& axis, Painter& painter) {
  constexpr float kMinDistance = 0.7f;  // [pixel] from one tick to the next
  const float u = painter.sheet.unit();
  Vec2 last[2] = {Vec2(-1e9f), Vec2(-1e9f)};
  for (const Endpoint& endpoint : endpoints) {
    const Vec2 at = axis.at(endpoint.at), way = (endpoint.is_end ? kBracket : -kBracket) * u * axis.outward();
    if (length(at - last[endpoint.is_end]) < kMinDistance) continue;
    last[endpoint.is_end] = at;
    painter.sheet.line(at, at + way, to_rgba(painter.theme.begin, endpoint.is_end ? 0.4f : 0.8f), 1.5f * u);
  }
}

void draw_drops(const FrameView& view, const SweepAxis& axis, const Projection& projection, Painter& painter) {
  const Inspection& inspection = view.inspection;
  for (const Endpoint& endpoint : inspection.endpoints) {
    Vec3 extreme = inspection.bodies.position_of(endpoint.body);
    extreme[inspection.axis] = endpoint.at;
    if (!projection.sees(extreme)) continue;
    painter.sheet.dotted(projection.at(extreme), axis.at(endpoint.at), to_rgba(painter.theme.begin, 0.6f),
                         2.5f * painter.sheet.unit());
  }
}

/// b0, e0, … beside their brackets: each in the first of a few rows where it overlaps no earlier label.
void draw_labels(const std::vector<Endpoint>& endpoints, const SweepAxis& axis, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  std::array<std::optional<Vec2>, static_cast<size_t>(kRows)> last;  // the label's end along the axis, in x
  const float height = sheet.size_of("0", TextSize::small).y;
  for (const Endpoint& endpoint : endpoints) {
    const std::string name = name_of(endpoint);
    const Vec2 size = sheet.size_of(name, TextSize::small);
    const float half = (axis.is_upright() ? size.y : size.x) / 2, row_size = axis.is_upright() ? 1.8f * height : height;
    const Vec2 foot = axis.at(endpoint.at) + kLabels * u * axis.outward();
    for (size_t row = 0; row < last.size(); ++row) {
      if (last[row] && dot(foot - *last[row], axis.along()) < half + 3 * u) continue;
      last[row] = foot + half * axis.along();
      const Vec2 at = foot + (static_cast<float>(row) + 0.5f) * row_size * axis.outward();
      sheet.text(at, kCentre, to_rgba(painter.theme.text), name, TextSize::small);
      break;
    }
  }
}

}  // namespace

float intervals_room(const Inspection& inspection) {
  if (inspection.axis < 0) return 0;
  return inspection.endpoints.size() <= kMaxLabels ? 0.21f : 0.06f;
}

void draw_intervals(const FrameView& view, Painter& painter) {
  const std::vector<Endpoint>& endpoints = view.inspection.endpoints;
  if (view.inspection.axis < 0 || endpoints.empty()) return;
  const Projection projection(view.camera, painter.sheet);
  const float u = painter.sheet.unit();
  const bool has_labels = endpoints.size() <= kMaxLabels;
  const Walk walk = shown_walk(endpoints, view.selected);
  const std::optional<Row> row = take_row(endpoints, painter);
  const float labels = has_labels ? kRows * painter.sheet.size_of("0", TextSize::small).y + kLabels * u : 30 * u;
  const float bottom = static_cast<float>(painter.sheet.height()) - painter.taken - labels;
  const SweepAxis axis(view, projection, bottom, u);

  if (has_labels) draw_drops(view, axis, projection, painter);
  axis.draw(painter);
  if (walk.body >= 0) {
    painter.sheet.line(axis.at(endpoints[walk.first].at), axis.at(endpoints[walk.last].at),
                       to_rgba(painter.theme.begin), 9 * u);
    const std::string body = std::to_string(walk.body);
    painter.note({{Swatch::arrow, painter.theme.begin, "thread of b" + body + " walks to e" + body}});
    painter.note({{row ? Swatch::square : Swatch::none, painter.theme.candidate,
                   "and tests " + counted(static_cast<int64_t>(walk.met.size()), "begin")}});
  }
  if (has_labels) {
    for (const Endpoint& endpoint : endpoints) draw_bracket(endpoint, axis, painter);
    draw_labels(endpoints, axis, painter);
  } else {
    draw_ticks(endpoints, axis, painter);
  }
  if (row) draw_list(endpoints, walk, *row, painter);
}

}  // namespace ballpit
