// SPDX-License-Identifier: MIT
#include "render/overlays/sweep_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpit {

namespace {

// [1/1080 of the picture's height]
constexpr float kDistance = 34;  // from the domain's edge to the axis
constexpr float kBeyond = 26;    // by how much the axis is longer at both ends

/// How far outside an edge of the domain lies in the picture: the axis is drawn beside the outermost one.
float outwardness(const Vec2& middle, bool is_upright) { return is_upright ? -middle.x : middle.y; }

}  // namespace

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

}  // namespace ballpit
