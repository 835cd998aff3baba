// SPDX-License-Identifier: MIT
// From a point in space to a pixel of the picture, for what is drawn on the sheet.
#pragma once

#include "render/camera.h"
#include "render/sheet.h"

namespace ballpit {

class Projection {
 public:
  Projection(const Camera& camera, const Sheet& sheet)
      : camera_(camera),
        view_(camera.view()),
        clip_(camera.projection() * view_),
        size_(sheet.width(), sheet.height()) {}

  /// [m] from the eye's plane.
  float depth(const Vec3& point) const { return -(view_ * Vec4(point, 1)).z; }

  bool sees(const Vec3& point) const { return depth(point) > camera_.near; }

  /// [pixel] from the upper left corner; y goes down. Only for a point that is seen.
  Vec2 at(const Vec3& point) const {
    const Vec4 clip = clip_ * Vec4(point, 1);
    return Vec2(1 + clip.x / clip.w, 1 - clip.y / clip.w) / 2.0f * size_;
  }

  /// [pixel] A length at a point, seen from the side.
  float length_at(const Vec3& point, float length) const {
    return length / camera_.pixel_size(depth(point), static_cast<int>(size_.y));
  }

  /// The same pixel, but nearer by `way`: what lies inside a sphere comes before it, and behind what hides the sphere.
  Vec3 lift(const Vec3& point, float way) const {
    const Vec3 eyewards = camera_.is_orthographic() ? camera_.eye - camera_.target : camera_.eye - point;
    return point + way * normalize(eyewards);
  }

 private:
  Camera camera_;
  Mat4 view_, clip_;
  Vec2 size_;
};

}  // namespace ballpit
