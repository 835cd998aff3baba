// SPDX-License-Identifier: MIT
#include "show/view.h"

#include <cmath>

namespace ballpit {

namespace {

constexpr float kHalfTurn = 3.14159265f;
constexpr float kSteepest = 0.49f * kHalfTurn;  // a view from straight above has no up direction
constexpr float kZoomPerClick = 1.15f;

}  // namespace

Ray ray_through(const Camera& camera, Vec2 place) {
  place -= camera.shift;
  const Vec3 forward = normalize(camera.target - camera.eye);
  const Vec3 right = normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  if (camera.is_orthographic()) {
    const float half = camera.orthographic_height / 2;
    return {camera.eye + half * (place.x * camera.aspect * right + place.y * up), forward};
  }
  const float half = std::tan(camera.fov / 2);
  return {camera.eye, normalize(forward + half * (place.x * camera.aspect * right + place.y * up))};
}

bool View::shows(std::string_view overlay) const {
  return std::find(overlays.begin(), overlays.end(), overlay) != overlays.end();
}

void View::toggle(std::string_view overlay) {
  const auto found = std::find(overlays.begin(), overlays.end(), overlay);
  if (found != overlays.end()) {
    overlays.erase(found);
  } else {
    overlays.emplace_back(overlay);
  }
}

void View::orbit(float right, float down) {
  azimuth = std::remainder(azimuth - right * kHalfTurn, 2 * kHalfTurn);
  elevation = std::clamp(elevation + down * kHalfTurn, -kSteepest, kSteepest);
}

void View::zoom_by(float clicks) { zoom = std::clamp(zoom * std::pow(kZoomPerClick, clicks), kMinZoom, kMaxZoom); }

void View::reset() {
  azimuth = kThreeQuarterAzimuth;
  elevation = kThreeQuarterElevation;
  zoom = 1;
}

View View::turned(double time) const {
  View view = *this;
  const double degrees = std::remainder(turn * time, 360.0);
  view.azimuth = std::remainder(azimuth + static_cast<float>(degrees) * kHalfTurn / 180, 2 * kHalfTurn);
  return turn == 0 ? *this : view;
}

void View::set_turn(float speed, double time) {
  azimuth = View{.azimuth = azimuth, .turn = turn - speed}.turned(time).azimuth;
  turn = speed;
}

Camera camera_of(const View& view, const DomainBox& domain, float aspect) {
  const auto [min, max] = domain.framed.value_or(FramedBox{domain.min, domain.max});
  const auto frame = view.turn == 0 ? frame_box_from : frame_turning_box;
  Camera camera =
      domain.is_planar() ? frame_box(min, max, 2, aspect) : frame(min, max, view.azimuth, view.elevation, aspect);
  camera.orthographic_height /= view.zoom;
  camera.fov = 2 * std::atan(std::tan(camera.fov / 2) / view.zoom);
  return camera;
}

Camera camera_of(const View& view, const DomainBox& domain, const Room& room, float aspect) {
  return leave_room(camera_of(view, domain, aspect * room.width() / room.height()), room, aspect);
}

int64_t body_at(const Camera& camera, const BodySnapshot& bodies, Vec2 place) {
  const Ray ray = ray_through(camera, place);
  int64_t nearest = -1;
  float nearest_distance = INFINITY;
  for (int64_t i = 0; i < bodies.count; ++i) {
    const Vec3 to = bodies.position_of(i) - ray.from;
    const float ahead = dot(to, ray.along), radius = bodies.radius_of(i);
    const float aside_squared = dot(to, to) - ahead * ahead;
    if (ahead <= 0 || aside_squared > radius * radius) continue;
    const float distance = ahead - std::sqrt(radius * radius - aside_squared);
    if (distance >= nearest_distance) continue;
    nearest = i;
    nearest_distance = distance;
  }
  return nearest;
}

}  // namespace ballpit
