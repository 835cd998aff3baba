// SPDX-License-Identifier: MIT
// The camera: a value from which the view and projection matrices are computed. Spatial scenes are shown in
// perspective, planar ones from the front without perspective.
#pragma once

#include "core/math.h"

namespace ballpit {

struct Camera {
  Vec3 eye{0.0f, 0.0f, 1.0f};  ///< [m]
  Vec3 target{0.0f};           ///< [m]
  Vec3 up{0.0f, 1.0f, 0.0f};
  float fov = 0.6108652f;            ///< vertical field of view [rad]: 35°
  float near = 0.1f;                 ///< [m]
  float far = 10.0f;                 ///< [m]
  float aspect = 16.0f / 9.0f;       ///< width / height
  float orthographic_height = 0.0f;  ///< [m] height of the visible area; 0: perspective
  Vec2 shift{0.0f};                  ///< of the picture's content, in halves of the picture: right and up

  bool is_orthographic() const { return orthographic_height > 0.0f; }
  Mat4 view() const;
  Mat4 projection() const;

  /// The length [m] that one pixel shows at `distance` in front of the eye, in a picture of `height` pixels.
  float pixel_size(float distance, int height) const;
};

/// The three-quarter view shows two walls and the floor.
inline constexpr float kThreeQuarterAzimuth = 30.0f * 3.14159265f / 180,
                       kThreeQuarterElevation = 20.0f * 3.14159265f / 180;

/// Corner k of a box, 0 to 7: bit 0 of k chooses the x of `max`, bit 1 its y, bit 2 its z.
inline Vec3 corner_of(const Vec3& min, const Vec3& max, int k) {
  return {k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z};
}

/// A camera that shows the whole box with a margin: the three-quarter view in perspective for 3 dimensions, along −z
/// without perspective for 2. The eye is as close as possible with all eight corners in view.
Camera frame_box(Vec3 min, Vec3 max, int dimensions, float aspect);

/// The same along another direction, for the panel's orbit. Angles in radians; azimuth 0 looks along −z.
Camera frame_box_from(Vec3 min, Vec3 max, float azimuth, float elevation, float aspect);

/// The same for a camera that turns about the vertical through the middle: as close as possible with the whole box in
/// view from every azimuth, so that the box keeps its size while the camera turns.
Camera frame_turning_box(Vec3 min, Vec3 max, float azimuth, float elevation, float aspect);

/// The same view in coordinates in which `origin` is 0 and `length` [m] is 1.
Camera in_units(Camera camera, const Vec3& origin, float length);

/// Parts of a picture's width and height that remain free at its edges.
struct Room {
  float left = 0, right = 0, below = 0, above = 0;

  float width() const { return 1 - left - right; }
  float height() const { return 1 - below - above; }
  bool operator==(const Room&) const = default;
};

/// A camera that was made for the part of a picture between the room, for the whole picture with this aspect.
Camera leave_room(Camera camera, const Room& room, float aspect);

/// The same view, smaller, in the upper part of the picture: `fraction` of the height remains free below.
inline Camera leave_room_below(const Camera& camera, float fraction) {
  return leave_room(camera, {.below = fraction}, camera.aspect);
}

}  // namespace ballpit
