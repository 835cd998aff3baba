// SPDX-License-Identifier: MIT
#include "render/overlays/intervals.h"

#include <algorithm>
#include <array>
#include <optional>

#include "broad_phase/inspection.h"
#include "render/overlays/interval_list.h"
#include "render/overlays/staff.h"
#include "render/painter.h"
#include "world/inspection.h"

namespace ballpit {

namespace {

constexpr float kBracket = 16, kSerif = 8, kLabels = 20, kRows = 3;  // on the axis

/// A bracket around the place: [ filled, ] hollow.
void draw_bracket(const Endpoint& endpoint, const Staff& staff, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const Rgba color = to_rgba(painter.theme.begin);
  const Vec2 up = kBracket * u * staff.outward(), at = staff.at(endpoint.at);
  const Vec2 serif = (endpoint.is_end ? -kSerif : kSerif) * u * staff.along();
  const float width = (endpoint.is_end ? 3 : 5) * u;
  sheet.line(at - up, at + up, color, width);
  for (const Vec2& end : {at - up, at + up}) sheet.line(end, end + serif, color, width);
  if (!endpoint.is_end) sheet.line(at + 0.5f * serif - up, at + 0.5f * serif + up, color, kSerif * u);
}

/// In a crowd: begins towards the scene, ends away from it; those on the same pixel once.
void draw_ticks(const std::vector<Endpoint>& endpoints, const Staff& staff, Painter& painter) {
  constexpr float kLeast = 0.7f;  // [pixel] from one to the next
  const float u = painter.sheet.unit();
  Vec2 last[2] = {Vec2(-1e9f), Vec2(-1e9f)};
  for (const Endpoint& endpoint : endpoints) {
    const Vec2 at = staff.at(endpoint.at), way = (endpoint.is_end ? kBracket : -kBracket) * u * staff.outward();
    if (length(at - last[endpoint.is_end]) < kLeast) continue;
    last[endpoint.is_end] = at;
    painter.sheet.line(at, at + way, to_rgba(painter.theme.begin, endpoint.is_end ? 0.4f : 0.8f), 1.5f * u);
  }
}

void draw_drops(const FrameView& view, const Staff& staff, const Projection& projection, Painter& painter) {
  const Inspection& inspection = view.inspection;
  for (const Endpoint& endpoint : inspection.endpoints) {
    Vec3 extreme = inspection.bodies.position_of(endpoint.body);
    extreme[inspection.axis] = endpoint.at;
    if (!projection.sees(extreme)) continue;
    painter.sheet.dotted(projection.at(extreme), staff.at(endpoint.at), to_rgba(painter.theme.begin, 0.6f),
                         2.5f * painter.sheet.unit());
  }
}

/// b0, e0, … beside their brackets: each in the first of a few rows where it touches no label before.
void draw_labels(const std::vector<Endpoint>& endpoints, const Staff& staff, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  std::array<std::optional<Vec2>, static_cast<size_t>(kRows)> last;  // the label's end along the axis, in x
  const float height = sheet.size_of("0", TextSize::small).y;
  for (const Endpoint& endpoint : endpoints) {
    const std::string name = name_of(endpoint);
    const Vec2 size = sheet.size_of(name, TextSize::small);
    const float half = (staff.is_upright() ? size.y : size.x) / 2,
                row_size = staff.is_upright() ? 1.8f * height : height;
    const Vec2 foot = staff.at(endpoint.at) + kLabels * u * staff.outward();
    for (size_t row = 0; row < last.size(); ++row) {
      if (last[row] && dot(foot - *last[row], staff.along()) < half + 3 * u) continue;
      last[row] = foot + half * staff.along();
      const Vec2 at = foot + (static_cast<float>(row) + 0.5f) * row_size * staff.outward();
      sheet.text(at, kCentre, to_rgba(painter.theme.text), name, TextSize::small);
      break;
    }
  }
}

}  // namespace

float intervals_room(const Inspection& inspection) {
  if (inspection.axis < 0) return 0;
  return inspection.endpoints.size() <= kMostLabels ? 0.21f : 0.06f;
}

void IntervalsOverlay::draw(const FrameView& view, Painter& painter, Layer layer) {
  const std::vector<Endpoint>& endpoints = view.inspection.endpoints;
  if (layer != Layer::over || view.inspection.axis < 0 || endpoints.empty()) return;
  const Projection projection(view.camera, painter.sheet);
  const float u = painter.sheet.unit();
  const bool has_labels = endpoints.size() <= kMostLabels;
  const Walk walk = shown_walk(endpoints, view.selected);
  const std::optional<Row> row = take_row(endpoints, painter);
  const float labels = has_labels ? kRows * painter.sheet.size_of("0", TextSize::small).y + kLabels * u : 30 * u;
  const float bottom = static_cast<float>(painter.sheet.height()) - painter.taken - labels;
  const Staff staff(view, projection, bottom, u);

  if (has_labels) draw_drops(view, staff, projection, painter);
  staff.draw(painter);
  if (walk.body >= 0) {
    painter.sheet.line(staff.at(endpoints[walk.first].at), staff.at(endpoints[walk.last].at),
                       to_rgba(painter.theme.begin), 9 * u);
    const std::string body = std::to_string(walk.body);
    painter.note({{Swatch::arrow, painter.theme.begin, "thread of b" + body + " walks to e" + body}});
    painter.note({{row ? Swatch::square : Swatch::none, painter.theme.candidate,
                   "and tests " + counted(static_cast<int64_t>(walk.met.size()), "begin")}});
  }
  if (has_labels) {
    for (const Endpoint& endpoint : endpoints) draw_bracket(endpoint, staff, painter);
    draw_labels(endpoints, staff, painter);
  } else {
    draw_ticks(endpoints, staff, painter);
  }
  if (row) draw_list(endpoints, walk, *row, painter);
}

}  // namespace ballpit
