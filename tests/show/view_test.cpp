// SPDX-License-Identifier: MIT
// What is seen of a scene, and which sphere is under the mouse.
#include "show/view.h"

#include <catch2/catch.hpp>

using namespace ballpit;

namespace {

BodySnapshot three_in_a_row() {
  BodySnapshot bodies;
  bodies.count = 3;
  bodies.position = {0.5f, 0.5f, 0.2f, 0.5f, 0.5f, 0.8f, 0.1f, 0.1f, 0.5f};  // 1 stands before 0
  bodies.radius = {0.1f};
  return bodies;
}

}  // namespace

TEST_CASE("the nearest of the spheres under the mouse is picked, and none beside them") {
  const DomainBox box;
  const View view{.azimuth = 0, .elevation = 0};
  const Camera camera = camera_of(view, box, 1.5f);
  CHECK(body_at(camera, three_in_a_row(), {0, 0}) == 1);
  CHECK(body_at(camera, three_in_a_row(), {0.9f, 0.9f}) == -1);
  CHECK(body_at(camera_of({.azimuth = 3.14159265f, .elevation = 0}, box, 1.5f), three_in_a_row(), {0, 0}) == 0);
}

TEST_CASE("a planar scene is picked from straight on") {
  const DomainBox box{Vec3(0), Vec3(2, 1, 0), 2, false};
  BodySnapshot bodies;
  bodies.count = 2;
  bodies.dimensions = 2;
  bodies.position = {0.5f, 0.5f, 1.5f, 0.5f};
  bodies.radius = {0.2f};
  const Camera camera = camera_of({}, box, 2);
  CHECK(body_at(camera, bodies, {-0.44f, 0}) == 0);
  CHECK(body_at(camera, bodies, {0.44f, 0}) == 1);
  CHECK(body_at(camera, bodies, {0, 0}) == -1);
}

TEST_CASE("zooming in makes what is seen smaller, in space and in the plane") {
  const DomainBox box, plane{Vec3(0), Vec3(1, 1, 0), 2, false};
  View view;
  const float fov = camera_of(view, box, 1).fov, height = camera_of(view, plane, 1).orthographic_height;
  view.zoom_by(1);
  CHECK(camera_of(view, box, 1).fov < fov);
  CHECK(camera_of(view, plane, 1).orthographic_height == Approx(height / view.zoom));
  view.zoom_by(1000);
  CHECK(view.zoom <= 50);
  view.zoom_by(-1000);
  CHECK(view.zoom >= 0.25f);
}

TEST_CASE("orbiting goes round, and never over the top") {
  View view;
  view.orbit(0, 100);
  CHECK(view.elevation < 1.5708f);
  view.orbit(0, -100);
  CHECK(view.elevation > -1.5708f);
  const float azimuth = view.azimuth;
  view.orbit(2, 0);  // a whole turn
  CHECK(view.azimuth == Approx(azimuth).margin(1e-5));
}

TEST_CASE("an overlay is shown once, or not") {
  View view;
  CHECK(view.shows("grid"));
  view.toggle("grid");
  CHECK_FALSE(view.shows("grid"));
  view.toggle("pairs");
  CHECK(view.overlays == std::vector<std::string>{"pairs"});
}

TEST_CASE("a sphere is picked where the picture shows its centre, also where overlays or a page move the scene") {
  for (const int dimensions : {2, 3}) {
    const DomainBox box{Vec3(0), Vec3(1, 1, dimensions == 2 ? 0 : 1), dimensions, false};
    BodySnapshot bodies;
    bodies.count = 3;
    bodies.position = {0.2f, 0.2f, 0, 0.8f, 0.3f, 0, 0.5f, 0.9f, 0};
    bodies.radius = {0.05f};
    const Camera whole = camera_of({}, box, 1.6f);
    for (const Camera& camera :
         {whole, leave_room_below(whole, 0.3f), leave_room(camera_of({}, box, 0.9f), {0, 0.45f, 0.35f, 0.06f}, 1.6f)}) {
      const Mat4 clip = camera.projection() * camera.view();
      for (int64_t i = 0; i < bodies.count; ++i) {
        const Vec4 at = clip * Vec4(bodies.position_of(i), 1);
        CHECK(body_at(camera, bodies, Vec2(at.x, at.y) / at.w) == i);
      }
    }
  }
}
