// SPDX-License-Identifier: MIT
// Shows sort and sweep (slides 2 to 4): the axis beside the scene, the begin and end of each sphere on it, the sorted
// list and the walk of one thread along that list.
//
//          ( 0 )  ( 1 )
//          ⋮   ⋮  ⋮   ⋮                dotted: from a sphere's ends to the axis
//     ─────[───]──[───]─────▶ x        begin: a filled bracket; end: a hollow one
//          b0  e0 b1  e1
//           ┌─────────┐   T         the list, and an arrow from the thread's begin to its end; the begins that it
//     ┌──┬──┴──┬──┬───▼┬──┐         meets are sky; ends are grey: their threads return at once
//     │b0│ b1  │b2│ e1 │e0│
//     └──┴─────┴──┴────┴──┘
//
// With many spheres there is only room for the brackets. Cost: proportional to the number of spheres.
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "render/overlays/overlay.h"
#include "render/page_view.h"

namespace ballpit {

namespace {

// [1/1080 of the picture's height]
constexpr float kBracket = 16, kSerif = 8, kLabels = 20;  // on the axis
constexpr float kDistance = 34;                           // from the domain's edge to the axis
constexpr float kBeyond = 26;                             // by how much the axis is longer at both ends

constexpr float kRows = 3;             // of labels
constexpr size_t kMaxLabels = 2 * 24;  // the endpoints of a longer list have no names

/// "b3" or "e3".
std::string name_of(const Endpoint& endpoint) {
  return fmt::format("{}{}", endpoint.is_end ? 'e' : 'b', endpoint.body);
}

/// How far outside an edge of the domain lies in the picture: the axis is drawn beside the outermost one.
float outwardness(const Vec2& middle, bool is_upright) { return is_upright ? -middle.x : middle.y; }

/// The drawn axis, beside an edge of the domain.
struct SweepAxis {
  /// Below the domain for x and z, left of it for y; in spatial scenes along the lower edge nearest to the viewer. It
  /// stays above `bottom` [pixel].
  SweepAxis(const FrameView& view, const Projection& space, float bottom, float unit);

  Vec2 at(float value) const;  ///< [pixel] of a coordinate on the axis
  void draw(Painter& painter) const;

  const Projection& projection;
  int axis;
  bool is_upright;
  float low, high;
  Vec3 edge;            ///< a point of the domain's edge
  Vec2 along, outward;  ///< unit vectors: towards larger coordinates, and away from the domain
  Vec2 offset{0.0f};    ///< [pixel] of the axis from that edge
};

SweepAxis::SweepAxis(const FrameView& view, const Projection& space, float bottom, float unit)
    : projection(space),
      axis(view.inspection.axis),
      is_upright(axis == 1),
      low(view.domain.min[axis]),
      high(view.domain.max[axis]) {
  float best = -std::numeric_limits<float>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 point = corner_of(view.domain.min, view.domain.max, corner);
    point[axis] = (low + high) / 2;
    if (!space.sees(point)) continue;
    const float out = outwardness(space.at(point), is_upright);
    if (out <= best) continue;
    best = out;
    edge = point;
  }
  const Vec2 from = at(low), to = at(high);
  along = length(to - from) > 1 ? normalize(to - from) : Vec2(1, 0);
  outward = Vec2(-along.y, along.x);
  if (outwardness(outward, is_upright) < 0) outward = -outward;
  offset = kDistance * unit * outward;
  const float excess = std::max(from.y, to.y) + offset.y - bottom;
  if (excess > 0 && !is_upright) offset.y -= excess;
}

Vec2 SweepAxis::at(float value) const {
  Vec3 point = edge;
  point[axis] = value;
  return projection.at(point) + offset;
}

void SweepAxis::draw(Painter& painter) const {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const char* name = axis == 0 ? "x" : axis == 1 ? "y" : "z";
  const Vec2 end = at(high) + kBeyond * u * along;
  sheet.arrow(at(low) - kBeyond * u * along, end, painter.ink(0.8f), 3 * u);
  sheet.text(end + 16 * u * (is_upright ? -outward : along), kCentre, painter.ink(), name);
}

/// A bracket at the endpoint: [ filled, ] hollow.
void draw_bracket(const Endpoint& endpoint, const SweepAxis& axis, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const Rgba color = to_rgba(painter.theme.begin);
  const Vec2 up = kBracket * u * axis.outward, at = axis.at(endpoint.at);
  const Vec2 serif = (endpoint.is_end ? -kSerif : kSerif) * u * axis.along;
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
    const Vec2 at = axis.at(endpoint.at), way = (endpoint.is_end ? kBracket : -kBracket) * u * axis.outward;
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
    const float half = (axis.is_upright ? size.y : size.x) / 2, row_size = axis.is_upright ? 1.8f * height : height;
    const Vec2 foot = axis.at(endpoint.at) + kLabels * u * axis.outward;
    for (size_t row = 0; row < last.size(); ++row) {
      if (last[row] && dot(foot - *last[row], axis.along) < half + 3 * u) continue;
      last[row] = foot + half * axis.along;
      const Vec2 at = foot + (static_cast<float>(row) + 0.5f) * row_size * axis.outward;
      sheet.text(at, kCentre, to_rgba(painter.theme.text), name, TextSize::small);
      break;
    }
  }
}

/// The sorted list as a row of boxes at the picture's lower edge.
struct Row {
  float left, box, top, bottom;  // [pixel]

  Vec2 low(size_t k) const { return {left + static_cast<float>(k) * box, top}; }
  Vec2 high(size_t k) const { return {left + static_cast<float>(k + 1) * box, bottom}; }
  float middle(size_t k) const { return left + (static_cast<float>(k) + 0.5f) * box; }
};

constexpr float kBoxHeight = 40, kAbove = 46, kBelow = 12;  // [1/1080 of the picture's height]

void draw_box(const Endpoint& endpoint, size_t k, const Row& row, bool walks, bool is_met, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const Theme& theme = painter.theme;
  const float u = sheet.unit();
  const Rgba edge = endpoint.is_end && !walks ? to_rgba(theme.idle) : to_rgba(theme.begin);
  Rgba text = endpoint.is_end ? painter.ink(0.7f) : painter.ink();
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
  if (endpoint.is_end && !walks) {  // its thread ends at once
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

/// Room for the list, if its names fit.
std::optional<Row> take_row(const std::vector<Endpoint>& endpoints, Painter& painter) {
  const Sheet& sheet = painter.sheet;
  const float u = sheet.unit(), width = static_cast<float>(sheet.width()) - 32 * u;
  float text = 0;
  for (const Endpoint& endpoint : endpoints) text = std::max(text, sheet.size_of(name_of(endpoint), TextSize::small).x);
  const float box = std::min(width / static_cast<float>(endpoints.size()), std::max(64 * u, text + 12 * u));
  if (endpoints.size() > kMaxLabels || box < text + 5 * u) return std::nullopt;
  const float height = std::max(kBoxHeight * u, sheet.size_of("0", TextSize::small).y + 6 * u);
  const float top = painter.take_strip((kAbove + kBelow) * u + height);
  const float left = (static_cast<float>(sheet.width()) - box * static_cast<float>(endpoints.size())) / 2;
  return Row{left, box, top + kAbove * u, top + kAbove * u + height};
}

void draw_list(const std::vector<Endpoint>& endpoints, const Walk& walk, const Row& row, const PageView* page,
               Painter& painter) {
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const bool is_met = std::binary_search(walk.met.begin(), walk.met.end(), k);
    draw_box(endpoints[k], k, row, walk.body >= 0 && endpoints[k].body == walk.body, is_met, painter);
    if (page) mark_touched(*page, "list", static_cast<int64_t>(k), row.low(k), row.high(k), painter);
  }
  if (walk.body >= 0) draw_walk(walk, row, painter);
}

}  // namespace

Walk shown_walk(const std::vector<Endpoint>& endpoints, int64_t selected) {
  // The walk of a body meets the begins up to its end, without those up to its own begin.
  Walk walk;
  std::vector<std::pair<int, size_t>> begin(
      endpoints.size());  // of each body: number of begins so far, entry in the list
  int begins = 0, max = -1;
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const auto body = static_cast<size_t>(endpoints[k].body);
    if (body >= begin.size()) continue;
    if (!endpoints[k].is_end) {
      begin[body] = {++begins, k};
    } else if (begin[body].first > 0 &&
               (selected < 0 ? begins - begin[body].first > max : endpoints[k].body == selected)) {
      max = begins - begin[body].first;
      walk = {endpoints[k].body, begin[body].second, k, {}};
    }
  }
  if (walk.body < 0) return walk;
  for (size_t k = walk.first + 1; k < walk.last; ++k) {
    if (!endpoints[k].is_end) walk.met.push_back(k);
  }
  return walk;
}

float intervals_room(const Inspection& inspection, float text_scale) {
  if (inspection.axis < 0) return 0;
  return inspection.endpoints.size() <= kMaxLabels ? 0.07f + 0.14f * text_scale : 0.06f;
}

void draw_intervals(const FrameView& view, Painter& painter) {
  const std::vector<Endpoint>& endpoints = view.inspection.endpoints;
  if (view.inspection.axis < 0 || endpoints.empty()) return;
  const Projection projection(view.camera, painter.sheet);
  const float u = painter.sheet.unit();
  const bool has_labels = endpoints.size() <= kMaxLabels;
  const Walk walk = view.page && !view.page->walks ? Walk{} : shown_walk(endpoints, view.selected);
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
  if (row) draw_list(endpoints, walk, *row, view.page, painter);
}

}  // namespace ballpit
