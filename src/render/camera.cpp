// SPDX-License-Identifier: MIT
#include "render/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ballpit {

namespace {

constexpr float kMargin = 0.06f;  // of the picture, on each side at least

std::array<Vec3, 8> corners(Vec3 min, Vec3 max) {
  std::array<Vec3, 8> result;
  for (int i = 0; i < 8; ++i) result[i] = {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z};
  return result;
}

/// The depth E of the closest eye that has all points in view along one picture axis. A point at (a, f), across and forward,
/// is in view of an eye at (e, E) if |a − e| ≤ k (f − E). Each point gives two half-planes for (e, E); the extreme ones
/// intersect at the closest eye.
float closest_eye(const std::array<Vec3, 8>& points, Vec3 across, Vec3 forward, float k) {
  float high = -INFINITY;  // of  a − k f
  float low = -INFINITY;   // of −a − k f
  for (const Vec3& point : points) {
    const float a = dot(point, across);
    const float f = dot(point, forward);
    high = std::max(high, a - k * f);
    low = std::max(low, -a - k * f);
  }
  return -(high + low) / (2 * k);
}

/// The e from which the points extend equally far to both sides of the picture, for an eye at depth E: by bisection.
float centred_eye(const std::array<Vec3, 8>& points, Vec3 across, Vec3 forward, float depth) {
  float low = INFINITY;
  float high = -INFINITY;
  for (const Vec3& point : points) {
    low = std::min(low, dot(point, across));
    high = std::max(high, dot(point, across));
  }
  for (int step = 0; step < 40; ++step) {
    const float middle = (low + high) / 2;
    float left = INFINITY;
    float right = -INFINITY;
    for (const Vec3& point : points) {
      const float place = (dot(point, across) - middle) / (dot(point, forward) - depth);
      left = std::min(left, place);
      right = std::max(right, place);
    }
    (left + right > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

Camera frame_plane(Vec3 min, Vec3 max, float aspect) {
  const Vec3 size = max - min;
  Camera camera;
  camera.aspect = aspect;
  camera.orthographic_height = std::max(size.y, size.x / aspect) / (1 - 2 * kMargin);
  const float distance = camera.orthographic_height;
  camera.target = {(min.x + max.x) / 2, (min.y + max.y) / 2, 0.0f};
  camera.eye = camera.target + Vec3(0, 0, distance);
  camera.near = 0.5f * distance;
  camera.far = 1.5f * distance;
  return camera;
}

}  // namespace

Mat4 Camera::view() const { return glm::lookAt(eye, target, up); }

Mat4 Camera::projection() const {
  const float y = orthographic_height / 2;
  const Mat4 centred = is_orthographic() ? glm::ortho(-y * aspect, y * aspect, -y, y, near, far)
                                         : glm::perspective(fov, aspect, near, far);
  return shift == Vec2(0) ? centred : glm::translate(Mat4(1), Vec3(shift, 0)) * centred;
}

float Camera::pixel_size(float distance, int height) const {
  const float visible = is_orthographic() ? orthographic_height : 2 * distance * std::tan(fov / 2);
  return visible / static_cast<float>(height);
}

Camera in_units(Camera camera, const Vec3& origin, float length) {
  camera.eye = (camera.eye - origin) / length;
  camera.target = (camera.target - origin) / length;
  for (float* distance : {&camera.near, &camera.far, &camera.orthographic_height}) *distance /= length;
  return camera;
}

Camera leave_room_below(Camera camera, float fraction) {
  camera.fov = 2 * std::atan(std::tan(camera.fov / 2) / (1 - fraction));
  camera.orthographic_height /= 1 - fraction;
  camera.shift = (1 - fraction) * camera.shift + Vec2(0, fraction);
  return camera;
}

Camera frame_box(Vec3 min, Vec3 max, int dimensions, float aspect) {
  if (dimensions == 2) return frame_plane(min, max, aspect);
  return frame_box_from(min, max, kThreeQuarterAzimuth, kThreeQuarterElevation, aspect);
}

Camera frame_box_from(Vec3 min, Vec3 max, float azimuth, float elevation, float aspect) {
  Camera camera;
  camera.aspect = aspect;
  const Vec3 back(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                  std::cos(elevation) * std::cos(azimuth));
  const Vec3 forward = -back;
  const Vec3 right = normalize(glm::cross(forward, camera.up));
  const Vec3 upward = glm::cross(right, forward);

  const float k = std::tan(camera.fov / 2) * (1 - 2 * kMargin);
  const std::array<Vec3, 8> points = corners(min, max);
  const float depth =
      std::min(closest_eye(points, right, forward, k * aspect), closest_eye(points, upward, forward, k));
  camera.eye = centred_eye(points, right, forward, depth) * right +
               centred_eye(points, upward, forward, depth) * upward + depth * forward;

  float nearest = INFINITY;
  float farthest = 0;
  for (const Vec3& point : points) {
    const float distance = dot(point, forward) - depth;
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  camera.target = camera.eye + (nearest + farthest) / 2 * forward;
  camera.near = nearest / 8;  // spheres may rise above an open box, and the camera may move closer
  camera.far = 2 * farthest;
  return camera;
}

}  // namespace ballpit
