// SPDX-License-Identifier: MIT
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ballpit {

namespace {

constexpr float kFrameMargin = 0.06f;  // of the picture, on each side at least

using Points = std::vector<Vec3>;

/// The smallest and the largest value of all points.
template <class Value>
std::pair<float, float> range_of(const Points& points, const Value& value) {
  float low = INFINITY, high = -INFINITY;
  for (const Vec3& point : points) {
    low = std::min(low, value(point));
    high = std::max(high, value(point));
  }
  return {low, high};
}

/// The depth E of the closest eye that has all points in view along one picture axis. A point at (a, f), across and
/// forward, is in view of an eye at (e, E) if |a − e| ≤ k (f − E). Each point gives two half-planes for (e, E); the
/// extreme ones intersect at the closest eye.
float closest_eye(const Points& points, Vec3 across, Vec3 forward, float k) {
  const float high = range_of(points, [&](const Vec3& p) { return dot(p, across) - k * dot(p, forward); }).second;
  const float low = range_of(points, [&](const Vec3& p) { return dot(p, across) + k * dot(p, forward); }).first;
  return (low - high) / (2 * k);
}

/// The e from which the points extend equally far to both sides of the picture, for an eye at depth E: by bisection.
float centred_eye(const Points& points, Vec3 across, Vec3 forward, float depth) {
  auto [low, high] = range_of(points, [&](const Vec3& p) { return dot(p, across); });
  for (int step = 0; step < 40; ++step) {
    const float middle = (low + high) / 2;
    const auto [left, right] =
        range_of(points, [&](const Vec3& p) { return (dot(p, across) - middle) / (dot(p, forward) - depth); });
    (left + right > 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

Camera frame_plane(Vec3 min, Vec3 max, float aspect) {
  const Vec3 size = max - min;
  Camera camera;
  camera.aspect = aspect;
  camera.orthographic_height = std::max(size.y, size.x / aspect) / (1 - 2 * kFrameMargin);
  const float distance = camera.orthographic_height;
  camera.target = {(min.x + max.x) / 2, (min.y + max.y) / 2, 0.0f};
  camera.eye = camera.target + Vec3(0, 0, distance);
  camera.near = 0.5f * distance;
  camera.far = 1.5f * distance;
  return camera;
}

/// A camera that looks down from this direction, as close as possible with all points in view.
Camera frame_points(const Points& points, float azimuth, float elevation, float aspect) {
  Camera camera;
  camera.aspect = aspect;
  const Vec3 back(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                  std::cos(elevation) * std::cos(azimuth));
  const Vec3 forward = -back;
  const Vec3 right = normalize(glm::cross(forward, camera.up));
  const Vec3 upward = glm::cross(right, forward);

  const float k = std::tan(camera.fov / 2) * (1 - 2 * kFrameMargin);
  const float depth =
      std::min(closest_eye(points, right, forward, k * aspect), closest_eye(points, upward, forward, k));
  camera.eye = centred_eye(points, right, forward, depth) * right +
               centred_eye(points, upward, forward, depth) * upward + depth * forward;

  const auto [nearest, farthest] = range_of(points, [&](const Vec3& p) { return dot(p, forward) - depth; });
  camera.target = camera.eye + (nearest + farthest) / 2 * forward;
  camera.near = nearest / 8;  // spheres may rise above an open box, and the camera may move closer
  camera.far = 2 * farthest;
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

Camera leave_room(Camera camera, const Room& room, float aspect) {
  camera.fov = 2 * std::atan(std::tan(camera.fov / 2) / room.height());
  camera.orthographic_height /= room.height();
  camera.aspect = aspect;
  camera.shift =
      Vec2(room.width(), room.height()) * camera.shift + Vec2(room.left - room.right, room.below - room.above);
  return camera;
}

Camera frame_box(Vec3 min, Vec3 max, int dimensions, float aspect) {
  if (dimensions == 2) return frame_plane(min, max, aspect);
  return frame_box_from(min, max, kThreeQuarterAzimuth, kThreeQuarterElevation, aspect);
}

Camera frame_box_from(Vec3 min, Vec3 max, float azimuth, float elevation, float aspect) {
  Points corners;
  for (int i = 0; i < 8; ++i) corners.push_back(corner_of(min, max, i));
  return frame_points(corners, azimuth, elevation, aspect);
}

Camera frame_turning_box(Vec3 min, Vec3 max, float azimuth, float elevation, float aspect) {
  constexpr int kPoints = 64;  // of each circle, 1/800 of its radius off at most
  const Vec3 middle = (min + max) / 2.0f;
  const float radius = length(Vec3(max.x - min.x, 0, max.z - min.z)) / 2;
  Points circles;  // floor and ceiling of the cylinder that the turning box sweeps; they turn with the camera
  for (int k = 0; k < kPoints; ++k) {
    const float angle = azimuth + 6.2831853f * static_cast<float>(k) / kPoints;
    const Vec3 out = radius * Vec3(std::sin(angle), 0, std::cos(angle));
    for (const float y : {min.y, max.y}) circles.push_back(Vec3(middle.x, y, middle.z) + out);
  }
  return frame_points(circles, azimuth, elevation, aspect);
}

}  // namespace ballpit
