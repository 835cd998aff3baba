// SPDX-License-Identifier: MIT
// The view of a scene: camera, overlays, colours. Panel, keys and mouse change it.
#pragma once

#include <string>
#include <vector>

#include "render/coloring.h"

namespace ballpit {

inline constexpr float kMinZoom = 0.25f, kMaxZoom = 50;    ///< zoom
inline constexpr float kFastestTurn = 360, kSlowTurn = 6;  ///< turn; 6°/s is one round a minute
inline constexpr float kMinUiScale = 0.5f, kMaxUiScale = 3;

struct View {
  float azimuth = kThreeQuarterAzimuth;      ///< [rad]
  float elevation = kThreeQuarterElevation;  ///< [rad]
  float zoom = 1;                            ///< 1: the whole domain
  float turn = 0;                            ///< [°/s] of the scene's time, about the vertical; 0: the camera stands
  std::vector<std::string> overlays{"grid"};
  std::string theme{themes().front().name};
  std::string coloring{coloring_table().front().name};
  int64_t selected = -1;     ///< a body, or −1
  float ui_scale = 1;        ///< of the panel's text and widgets
  float text_scale = 1;      ///< of the scene's text
  bool has_caption = false;  ///< the scene's title, and how many tests it takes
  bool occlusion = true;     ///< spheres and floor are darker where spheres hide the sky or the light

  bool shows(std::string_view overlay) const;
  void toggle(std::string_view overlay);

  void orbit(float right, float down);  ///< distances dragged [fractions of the picture's height]
  void zoom_by(float clicks);           ///< of the mouse wheel
  void reset();                         ///< shows the whole domain in the three-quarter view

  /// The same view after the camera has turned for `time` [s].
  View turned(double time) const;

  /// Changes the speed without a leap of the camera at `time` [s].
  void set_turn(float speed, double time);
};

/// The camera of a view on a domain, in a picture of this width by height.
Camera camera_of(const View& view, const DomainBox& domain, float aspect);

/// The same in the room that a page leaves in the picture.
Camera camera_of(const View& view, const DomainBox& domain, const Room& room, float aspect);

/// The ray from the eye through a place in the picture, as of body_at(); `along` has length 1.
struct Ray {
  Vec3 from, along;
};
Ray ray_through(const Camera& camera, Vec2 place);

/// The body at a place in the picture, or −1. The place is measured from the middle, x to the right and y up, from −1
/// to 1.
int64_t body_at(const Camera& camera, const BodySnapshot& bodies, Vec2 place);

}  // namespace ballpit
