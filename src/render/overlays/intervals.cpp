// SPDX-License-Identifier: MIT
#include "render/overlays/intervals.h"

#include <algorithm>
#include <array>
#include <optional>

#include "render/overlays/staff.h"
#include "render/painter.h"

namespace ballpit {

namespace {

constexpr size_t kMostLabels = 2 * 24;
constexpr float kBoxHeight = 40, kAbove = 46, kBelow = 12;           // of the list [1/1080 of the picture's height]
constexpr float kBracket = 16, kSerif = 8, kLabels = 20, kRows = 3;  // on the axis

std::string name_of(const Endpoint& endpoint) {
  std::string name = std::to_string(endpoint.body);
  name.insert(name.begin(), endpoint.is_end ? 'e' : 'b');
  return name;
}

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

struct Row {
  float left, box, top, bottom;  // [pixel]

  Vec2 low(size_t k) const { return {left + static_cast<float>(k) * box, top}; }
  Vec2 high(size_t k) const { return {left + static_cast<float>(k + 1) * box, bottom}; }
  float middle(size_t k) const { return left + (static_cast<float>(k) + 0.5f) * box; }
};

void draw_box(const Endpoint& endpoint, size_t k, const Row& row, bool walks, bool is_met, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const Theme& theme = painter.theme;
  const float u = sheet.unit();
  const Rgba edge = endpoint.is_end && !walks ? to_rgba(theme.idle) : to_rgba(theme.begin);
  Rgba text = endpoint.is_end ? painter.ink(0.55f) : painter.ink();
  const Vec2 low = row.low(k) + Vec2(1.5f * u, 0), high = row.high(k) - Vec2(1.5f * u, 0);
  if (walks && !endpoint.is_end) {
    sheet.box(low, high, edge);
    text = to_rgba(Vec3(1));
  } else if (is_met) {
    sheet.box(low, high, to_rgba(theme.candidate));
    text = to_rgba(theme.on_body);
  } else if (endpoint.is_end) {
    sheet.box(low, high, to_rgba(theme.idle, 0.18f));
  }
  sheet.frame(low, high, edge, (walks ? 4 : 2) * u);
  sheet.text((low + high) / 2.0f, kCentre, text, name_of(endpoint), TextSize::small);
  if (endpoint.is_end) {  // its thread ends at once
    const Vec2 foot(row.middle(k), row.top), head = foot - Vec2(0, 10 * u);
    sheet.line(foot, head, to_rgba(theme.idle), 3 * u);
    sheet.line(head - Vec2(7 * u, 0), head + Vec2(7 * u, 0), to_rgba(theme.idle), 3 * u);
  }
}

/// From the thread's begin up, along the list and down on its end.
void draw_walk(const Walk& walk, const Row& row, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = 4 * u, above = row.top - 28 * u;
  const Rgba color = to_rgba(painter.theme.begin);
  const Vec2 begin(row.middle(walk.first), row.top), end(row.middle(walk.last), row.top - 2 * u);
  sheet.line(begin, {begin.x, above - width / 2}, color, width);
  sheet.line({begin.x, above}, {end.x + width / 2, above}, color, width);
  sheet.arrow({end.x, above}, end, color, width);
}

void draw_list(const std::vector<Endpoint>& endpoints, const Walk& walk, const Row& row, Painter& painter) {
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const bool is_met = std::binary_search(walk.met.begin(), walk.met.end(), k);
    draw_box(endpoints[k], k, row, walk.body >= 0 && endpoints[k].body == walk.body, is_met, painter);
  }
  if (walk.body >= 0) draw_walk(walk, row, painter);
}

/// The list's place at the lower edge, if its names fit.
std::optional<Row> take_row(const std::vector<Endpoint>& endpoints, Painter& painter) {
  const Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = static_cast<float>(sheet.width()) - 32 * u;
  float text = 0;
  for (const Endpoint& endpoint : endpoints) text = std::max(text, sheet.size_of(name_of(endpoint), TextSize::small).x);
  const float box = std::min(width / static_cast<float>(endpoints.size()), std::max(64 * u, text + 12 * u));
  if (endpoints.size() > kMostLabels || box < text + 5 * u) return std::nullopt;
  const float height = std::max(kBoxHeight * u, sheet.size_of("0", TextSize::small).y + 6 * u);
  const Strip strip = painter.take_strip((kAbove + kBelow) * u + height);
  const float left = (static_cast<float>(sheet.width()) - box * static_cast<float>(endpoints.size())) / 2;
  return Row{left, box, strip.top + kAbove * u, strip.top + kAbove * u + height};
}

}  // namespace

Walk shown_walk(const std::vector<Endpoint>& endpoints, int64_t selected) {
  // What a begin meets: the begins up to its end, without those up to itself.
  Walk walk;
  std::vector<std::pair<int, size_t>> begin(endpoints.size());  // of each body: begins so far, and entry
  int begins = 0, most = -1;
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const auto body = static_cast<size_t>(endpoints[k].body);
    if (body >= begin.size()) continue;
    if (!endpoints[k].is_end) {
      begin[body] = {++begins, k};
    } else if (begin[body].first > 0 &&
               (selected < 0 ? begins - begin[body].first > most : endpoints[k].body == selected)) {
      most = begins - begin[body].first;
      walk = {endpoints[k].body, begin[body].second, k, {}};
    }
  }
  if (walk.body < 0) return walk;
  for (size_t k = walk.first + 1; k < walk.last; ++k) {
    if (!endpoints[k].is_end) walk.met.push_back(k);
  }
  return walk;
}

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
    painter.note(
        {{Swatch::arrow, painter.theme.begin,
          "thread of b" + std::to_string(walk.body) + " walks to e" + std::to_string(walk.body) + " and tests"},
         {Swatch::square, painter.theme.candidate, counted(static_cast<int64_t>(walk.met.size()), "begin")}});
  }
  for (const Endpoint& endpoint : endpoints) draw_bracket(endpoint, staff, painter);
  if (has_labels) draw_labels(endpoints, staff, painter);
  if (row) draw_list(endpoints, walk, *row, painter);
}

}  // namespace ballpit
