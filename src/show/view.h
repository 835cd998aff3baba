// SPDX-License-Identifier: MIT
// How a scene is looked at: from where, with which overlays, in which colours. A value that panel, keys and mouse change.
#pragma once

#include <string>
#include <vector>

#include "render/camera.h"
#include "render/coloring.h"
#include "render/frame_view.h"
#include "render/theme.h"

namespace ballpit {

inline constexpr float kFarthest = 0.25f, kClosest = 50;  ///< zoom
inline constexpr float kSmallestUi = 0.5f, kLargestUi = 3;

struct View {
  float azimuth = kThreeQuarterAzimuth;      ///< [rad]
  float elevation = kThreeQuarterElevation;  ///< [rad]
  float zoom = 1;                            ///< 1: the whole domain
  std::vector<std::string> overlays{"grid"};
  std::string theme{themes().front().name};
  std::string coloring{coloring_table().front().name};
  int64_t selected = -1;  ///< a body, or −1
  float ui_scale = 1;     ///< of the panel's text and widgets, from kSmallestUi to kLargestUi

  bool shows(std::string_view overlay) const;
  void toggle(std::string_view overlay);

  /// The mouse was dragged so far [fractions of the picture's height], or its wheel turned.
  void orbit(float right, float down);
  void zoom_by(float clicks);
};

/// The camera of a view on a domain, in a picture of this width by height.
Camera camera_of(const View& view, const DomainBox& domain, float aspect);

/// The body that is seen at a place in the picture, x to the right and y up from its middle, each from −1 to 1; −1 where there
/// is none.
int64_t body_at(const Camera& camera, const BodySnapshot& bodies, Vec2 place);

}  // namespace ballpit
