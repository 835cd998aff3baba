// SPDX-License-Identifier: MIT
// The drawn axis of sort and sweep, beside an edge of the domain.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"
#include "render/projection.h"

namespace ballpit {

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

}  // namespace ballpit
