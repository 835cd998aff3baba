// SPDX-License-Identifier: MIT
// A scene looks the same at every length scale, from 1e-10 to 1e10 m.
#include <algorithm>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "render/overlays/overlay.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

constexpr int kWidth = 320, kHeight = 180;
constexpr float kAspect = 16.0f / 9;

/// The scene at scale 1. Velocities are in lengths of the scene per second, so their numbers stay the same.
struct Scenery {
  Inspection inspection;
  DomainBox domain;
  float azimuth = kThreeQuarterAzimuth, elevation = kThreeQuarterElevation, zoom = 1;
  std::vector<std::string> overlays{};
  int64_t selected = -1;
  RenderOptions options{};
};

void scale(std::vector<float>& values, double by) {
  for (float& value : values) value = static_cast<float>(value * by);
}

Vec3 scaled(const Vec3& v, double by) { return Vec3(Vec3d(v) * by); }

Image draw_at(double by, Scenery scenery) {
  Inspection& inspection = scenery.inspection;
  scale(inspection.bodies.position, by);
  scale(inspection.bodies.radius, by);
  for (Endpoint& endpoint : inspection.endpoints) endpoint.at = static_cast<float>(endpoint.at * by);
  for (GridInspection& grid : inspection.grids) {
    grid.origin = scaled(grid.origin, by);
    grid.edge = scaled(grid.edge, by);
  }
  DomainBox domain = scenery.domain;
  domain.min = scaled(domain.min, by);
  domain.max = scaled(domain.max, by);
  FrameView view = view_of(inspection, domain, kAspect, scenery.overlays);
  if (!domain.is_planar()) {
    view.camera = frame_box_from(domain.min, domain.max, scenery.azimuth, scenery.elevation, kAspect);
    view.camera.fov /= scenery.zoom;
    view.camera = leave_room_below(view.camera, room_below(scenery.overlays, inspection));
  }
  view.selected = scenery.selected;
  view.step = static_cast<float>(0.1 * by);
  return draw(view, kWidth, kHeight, scenery.options);
}

/// The largest difference of a channel, and how many pixels differ by more than one level.
struct Difference {
  int largest = 0, count = 0;
};

Difference compare(const Image& a, const Image& b) {
  Difference result;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const int apart = difference(a.pixel(x, y), b.pixel(x, y));
      result.largest = std::max(result.largest, apart);
      result.count += apart > 1;
    }
  }
  return result;
}

void check_every_scale(const Scenery& scenery) {
  const Image expected = draw_at(1, scenery);
  for (const double by : {1e-10, 1e-5, 1e5, 1e10}) {
    const Image actual = draw_at(by, scenery);
    const Difference apart = compare(actual, expected);
    INFO("scale " << by << ", overlays " << Catch::StringMaker<std::vector<std::string>>::convert(scenery.overlays)
                  << ", largest difference " << apart.largest);
    // Coordinates are rounded differently, so single pixels on the border of a line or a face may change.
    CHECK(apart.count <= kWidth * kHeight / 1000);
    CHECK(worst_block(actual, expected) <= 1);
    if (scenery.overlays.empty()) CHECK(apart.largest <= 3);
  }
}

Scenery spatial(const std::vector<std::string>& overlays = {}, float edge = 0.125f) {
  const DomainBox box;
  Scenery scenery{inspect(read_spheres(BALLPIT_GOLDEN_FOLDER "/cloud.csv"), box, edge), box};
  scenery.overlays = overlays;
  return scenery;
}

Scenery planar(const std::vector<std::string>& overlays = {}) {
  const DomainBox plane{Vec3(0), Vec3(5, 5, 0), 2, false};
  Scenery scenery{inspect(read_spheres(BALLPIT_GOLDEN_FOLDER "/plane_touching.csv"), plane, 0.4f), plane};
  scenery.overlays = overlays;
  return scenery;
}

Scenery complete(Scenery scenery) {
  add_candidates(scenery.inspection);
  add_endpoints(scenery.inspection, 0);
  add_velocities(scenery.inspection, scenery.domain);
  return scenery;
}

}  // namespace

TEST_CASE("spheres and discs look the same at every length scale") {
  check_every_scale(spatial());
  check_every_scale(planar());
  Scenery open = spatial();
  open.domain.open_top = true;
  open.options = {theme_named("dark"), 2};
  check_every_scale(open);
}

TEST_CASE("points look the same at every length scale") {
  Scenery scenery = spatial();
  for (float& radius : scenery.inspection.bodies.radius) radius = 1e-4f;
  check_every_scale(scenery);
}

TEST_CASE("every overlay looks the same at every length scale") {
  std::vector<std::string> all;
  for (const OverlayEntry& entry : overlay_table()) {
    const std::string name(entry.name);
    check_every_scale(complete(spatial({name})));
    check_every_scale(complete(planar({name})));
    all.push_back(name);
  }
  check_every_scale(complete(spatial(all)));
  check_every_scale(complete(planar(all)));
}

TEST_CASE("a selected sphere and missed contacts look the same at every length scale") {
  Scenery space = complete(spatial({"grid", "pairs"}, 0.03f)), plane = complete(planar({"grid", "pairs"}));
  space.selected = plane.selected = 3;
  check_every_scale(space);
  check_every_scale(plane);
}

TEST_CASE("every camera shows the same picture at every length scale") {
  for (const auto& [azimuth, elevation, zoom] : {std::tuple{0.0f, 0.0f, 1.0f},
                                                 {2.5f, 1.5f, 1.0f},
                                                 {-1.0f, -0.7f, 4.0f},
                                                 {0.5f, 0.3f, 20.0f},
                                                 {0.5f, 0.3f, 0.25f}}) {
    Scenery scenery = spatial({"grid"});
    scenery.azimuth = azimuth;
    scenery.elevation = elevation;
    scenery.zoom = zoom;
    check_every_scale(scenery);
  }
}
