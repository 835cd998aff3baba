// SPDX-License-Identifier: MIT
// Shows sort and sweep (slides 2 to 4): the axis beside the scene, the begin and end of each sphere on it, the sorted list
// and the walk of one thread along that list.
//
//          ( 0 )  ( 1 )
//          ⋮   ⋮  ⋮   ⋮                dotted: from a sphere's ends to the axis
//     ─────[───]──[───]─────▶ x        begin: a filled bracket; end: a hollow one
//          b0  e0 b1  e1
//     ┌──┬──┬──┬──┐
//     │b0│e0│b1│e1│                    the list: begins that the walk meets are sky, ends are grey
//     └──┴──┴──┴──┘
//
// With many spheres there is only room for the brackets. Cost: proportional to the number of spheres.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "broad_phase/inspection.h"
#include "render/overlays/interval_list.h"
#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "render/projection.h"
#include "world/inspection.h"

namespace ballpit {

namespace {

// [1/1080 of the picture's height]
constexpr float kBracket = 16, kSerif = 8, kLabels = 20;  // on the axis
constexpr float kDistance = 34;                           // from the domain's edge to the axis
constexpr float kBeyond = 26;                             // by how much the axis is longer at both ends

constexpr float kRows = 3;  // of labels

/// How far outside an edge of the domain lies in the picture: the axis is drawn beside the outermost one.
float outwardness(const Vec2& middle, bool is_upright) { return is_upright ? -middle.x : middle.y; }

/// The drawn axis, beside an edge of the domain.
class SweepAxis {
 public:
  /// Below the domain for x and z, left of it for y; in spatial scenes along the lower edge nearest to the viewer. It stays
  /// above `bottom` [pixel].
  SweepAxis(const FrameView& view, const Projection& projection, float bottom, float unit);

  Vec2 at(float value) const;                ///< [pixel] of a coordinate on the axis
  Vec2 along() const { return along_; }      ///< unit vector towards larger coordinates
  Vec2 outward() const { return outward_; }  ///< unit vector away from the domain
  bool is_upright() const { return axis_ == 1; }

  /// Draws the line with its arrow and name.
  void draw(Painter& painter) const;

 private:
  const Projection& projection_;
  int axis_;
  Vec3 edge_;  ///< a point of the domain's edge
  float low_, high_;
  Vec2 along_, outward_, offset_;
};

SweepAxis::SweepAxis(const FrameView& view, const Projection& projection, float bottom, float unit)
    : projection_(projection), axis_(view.inspection.axis) {
  const DomainBox& domain = view.domain;
  low_ = domain.min[axis_];
  high_ = domain.max[axis_];
  float best = -std::numeric_limits<float>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 point(corner & 1 ? domain.max.x : domain.min.x, corner & 2 ? domain.max.y : domain.min.y,
               corner & 4 ? domain.max.z : domain.min.z);
    point[axis_] = (low_ + high_) / 2;
    if (!projection.sees(point)) continue;
    const float out = outwardness(projection.at(point), is_upright());
    if (out <= best) continue;
    best = out;
    edge_ = point;
  }
  offset_ = Vec2(0);
  const Vec2 from = at(low_), to = at(high_);
  along_ = length(to - from) > 1 ? normalize(to - from) : Vec2(1, 0);
  outward_ = Vec2(-along_.y, along_.x);
  if (outwardness(outward_, is_upright()) < 0) outward_ = -outward_;
  offset_ = kDistance * unit * outward_;
  const float excess = std::max(from.y, to.y) + offset_.y - bottom;
  if (excess > 0 && !is_upright()) offset_.y -= excess;
}

Vec2 SweepAxis::at(float value) const {
  Vec3 point = edge_;
  point[axis_] = value;
  return projection_.at(point) + offset_;
}

void SweepAxis::draw(Painter& painter) const {
  Sheet& sheet = painter.sheet;
  const float u = sheet.unit();
  const char* name = axis_ == 0 ? "x" : axis_ == 1 ? "y" : "z";
  const Vec2 end = at(high_) + kBeyond * u * along_;
  sheet.arrow(at(low_) - kBeyond * u * along_, end, painter.ink(0.8f), 3 * u);
  sheet.text(end + 16 * u * (is_upright() ? -outward_ : along_), kCentre, painter.ink(), name);
}

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
