// SPDX-License-Identifier: MIT
// The axis of the sweep as it is drawn: beside an edge of the domain, like a staff under a melody.
#pragma once

#include "render/frame_view.h"
#include "render/painter.h"
#include "render/projection.h"

namespace ballpit {

class Staff {
 public:
  /// Below the domain for x and z, left of it for y; spatial: along the lower edge nearest to the viewer. It stays above
  /// `bottom` [pixel].
  Staff(const FrameView& view, const Projection& projection, float bottom, float unit);

  Vec2 at(float value) const;                ///< [pixel] where a coordinate lies on the axis
  Vec2 along() const { return along_; }      ///< unit vector towards larger coordinates
  Vec2 outward() const { return outward_; }  ///< unit vector away from the domain
  bool is_upright() const { return axis_ == 1; }

  /// The line itself with its arrow and name.
  void draw(Painter& painter) const;

 private:
  const Projection& projection_;
  int axis_;
  Vec3 edge_;  ///< a point of the domain's edge
  float low_, high_;
  Vec2 along_, outward_, offset_;
};

}  // namespace ballpit
