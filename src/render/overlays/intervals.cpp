// SPDX-License-Identifier: MIT
// Shows sort and sweep (slides 2 to 4): the axis beside the scene, the begin and end of each sphere on it, and the
// sorted list.
//
//          ( 0 )  ( 1 )
//          ⋮   ⋮  ⋮   ⋮                dotted: from a sphere's ends to the axis
//     ─────[───]──[───]─────▶ x        begin: a filled bracket; end: a hollow one
//          │   ╎   ╲   ╲               from each mark to its entry: crossing lines show that the list is unsorted
//     ┌──┬───┬───┬───┬──┐
//     │b0│e0 │b1 │b2 │e1│              the list: interval_list.h
//     └──┴───┴───┴───┴──┘
//
// Without a list, the names stand at the brackets. With many spheres there is only room for the brackets. Cost:
// proportional to the number of spheres.
#include <array>
#include <cmath>
#include <limits>

#include "core/phrase.h"
#include "render/overlays/interval_list.h"

namespace ballpit {

namespace {

// [1/1080 of the picture's height]
constexpr float kBracket = 16, kSerif = 8, kLabels = 20;  // on the axis
constexpr float kDistance = 34;                           // from the domain's edge to the axis
constexpr float kBeyond = 26;                             // by how much the axis is longer at both ends

constexpr float kAbove = 96;  // from the brackets to the boxes of the list
constexpr int kRows = 3;      // of labels

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
  sheet.text(end + 16 * u * (is_upright ? -outward : along), kCentre, painter.ink(), name, TextSize::small);
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
    painter.sheet.line(at, at + way, to_rgba(painter.theme.begin), (endpoint.is_end ? 1 : 2) * u);
  }
}

/// From the sphere's surface to the axis, interrupted by the other spheres.
void draw_drops(const FrameView& view, const SweepAxis& axis, const Projection& projection, Painter& painter) {
  constexpr float kDot = 3, kEvery = 7;  // [1/1080 of the picture's height]
  const Inspection& inspection = view.inspection;
  const BodySnapshot& bodies = inspection.bodies;
  const float u = painter.sheet.unit();
  std::vector<std::pair<Vec2, float>> discs;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 centre = bodies.position_of(i);
    if (projection.sees(centre)) {
      discs.emplace_back(projection.at(centre), projection.length_at(centre, bodies.radius_of(i)));
    }
  }
  for (const Endpoint& endpoint : inspection.endpoints) {
    Vec3 extreme = bodies.position_of(endpoint.body);
    extreme[inspection.axis] = endpoint.at;
    if (!projection.sees(extreme)) continue;
    const Vec2 from = projection.at(extreme), way = axis.at(endpoint.at) - from;
    const int dots = static_cast<int>(length(way) / (kEvery * u));
    for (int k = 0; k <= dots; ++k) {
      const Vec2 at = from + way * (static_cast<float>(k) / static_cast<float>(std::max(dots, 1)));
      const auto covers = [&](const auto& disc) { return length(at - disc.first) < disc.second - kDot * u; };
      if (std::any_of(discs.begin(), discs.end(), covers)) continue;
      painter.sheet.disc(at, std::max(kDot * u, 1.0f) / 2, to_rgba(painter.theme.begin));
    }
  }
}

/// b0, e0, … beside their brackets: each in the first of a few rows where it overlaps no earlier label.
void draw_labels(const std::vector<Endpoint>& endpoints, const SweepAxis& axis, Painter& painter) {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  std::array<std::optional<Vec2>, kRows> last;  // the label's end along the axis, in x
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

/// From the brackets to the boxes.
void draw_links(const std::vector<Endpoint>& endpoints, const SweepAxis& axis, const Row& row, Painter& painter) {
  const float u = painter.sheet.unit();
  for (size_t k = 0; k < endpoints.size(); ++k) {
    const Vec2 from = axis.at(endpoints[k].at) + (kBracket + 4) * u * axis.outward;
    const Vec2 to(row.middle(k), row.top - 3 * u);
    if (endpoints[k].is_end) {
      painter.sheet.dotted(from, to, to_rgba(painter.theme.begin), 3 * u);
    } else {
      painter.sheet.line(from, to, to_rgba(painter.theme.begin), 2.5f * u);
    }
  }
}

}  // namespace

float intervals_room(const Inspection& inspection, float text_scale) {
  if (inspection.axis < 0) return 0;
  const size_t entries = inspection.endpoints.size();
  if (entries > kMaxLabels) return (kDistance + 2 * kBracket + 10) / 1080;
  return (kDistance + kBracket + kAbove + list_height(entries, text_scale)) / 1080;
}

void draw_intervals(const FrameView& view, Painter& painter) {
  const std::vector<Endpoint>& endpoints = view.inspection.endpoints;
  if (view.inspection.axis < 0 || endpoints.empty()) return;
  const Projection projection(view.camera, painter.sheet);
  const float u = painter.sheet.unit();
  const bool has_labels = endpoints.size() <= kMaxLabels;
  const std::vector<Walk> walks = shown_walks(endpoints, view.selected, view.page);
  const Vec3 centre = (view.domain.min + view.domain.max) / 2.0f;
  const float middle = projection.sees(centre) ? projection.at(centre).x : 0;
  const std::optional<Row> row = take_row(endpoints, middle, painter);
  const bool is_linked = row && view.inspection.axis != 1;
  const float label = painter.sheet.size_of("0", TextSize::small).y;
  const float labels = is_linked ? 40 * u : has_labels ? kRows * label + kLabels * u : 30 * u;
  const float bottom = static_cast<float>(painter.sheet.height()) - painter.taken - labels;
  const SweepAxis axis(view, projection, bottom, u);

  if (has_labels) draw_drops(view, axis, projection, painter);
  axis.draw(painter);
  if (walks.size() > 1) {
    painter.note({{Swatch::arrow, painter.theme.begin, phrase("{} threads walk: those of begins", walks.size())}});
    painter.note({{Swatch::stub, painter.theme.idle,
                   phrase("{} stop at once: those of ends", endpoints.size() - walks.size())}});
  } else if (!walks.empty()) {
    const Walk& walk = walks.front();
    painter.sheet.line(axis.at(endpoints[walk.first].at), axis.at(endpoints[walk.last].at),
                       to_rgba(painter.theme.begin), 9 * u);
    const std::string body = std::to_string(walk.body);
    painter.note({{Swatch::arrow, painter.theme.begin, phrase("thread of b{0} walks to e{0}", body)}});
    painter.note({{row ? Swatch::square : Swatch::none, painter.theme.candidate,
                   phrase("and tests {}", counted(static_cast<int64_t>(walk.met.size()), "begin"))}});
  }
  if (!row) {
    painter.note(phrase("Intervals: {} entries are too many to draw the list; show fewer spheres",
                        grouped(static_cast<int64_t>(endpoints.size()))));
  }
  if (has_labels) {
    for (const Endpoint& endpoint : endpoints) draw_bracket(endpoint, axis, painter);
  } else {
    draw_ticks(endpoints, axis, painter);
  }
  if (is_linked) {
    draw_links(endpoints, axis, *row, painter);
  } else if (has_labels) {
    draw_labels(endpoints, axis, painter);
  }
  if (row) draw_list(endpoints, walks, *row, view.page, painter);
}

}  // namespace ballpit
