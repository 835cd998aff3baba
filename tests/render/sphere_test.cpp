// SPDX-License-Identifier: MIT
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

constexpr int kSize = 200;  // pixels each way

/// Looks along −z from the origin at spheres in an invisible domain.
FrameView along_z(const Inspection& inspection) {
  Camera camera;
  camera.eye = Vec3(0);
  camera.target = Vec3(0, 0, -1);
  camera.near = 0.05f;
  camera.far = 50;
  camera.aspect = 1;
  const DomainBox behind{Vec3(-1, -90, 2), Vec3(1, 1, 3), 3, true};
  return {inspection, behind, camera, {}};
}

Image draw_spheres(const std::vector<Sphere>& spheres) {
  const Inspection inspection = inspect(spheres, DomainBox{});
  return draw(along_z(inspection), kSize, kSize);
}

/// The pixel of a viewing angle, from the left.
float column(float angle) { return kSize / 2 * (1 + std::tan(angle) / std::tan(Camera{}.fov / 2)); }

bool is_ground(const uint8_t* pixel) { return difference(pixel, themes().front().background) < 8; }

bool is_orange(const uint8_t* pixel) { return pixel[0] > pixel[2] + 60; }

struct Run {
  int first = -1, last = -1;
};

Run covered_columns(const Image& image, int row) {
  Run run;
  for (int x = 0; x < image.width; ++x) {
    if (is_ground(image.pixel(x, row))) continue;
    if (run.first < 0) run.first = x;
    run.last = x;
  }
  return run;
}

}  // namespace

TEST_CASE("a sphere's outline is the section of its tangent cone with the picture") {
  for (const Sphere& sphere : {Sphere{{0, 0, -3}, 0.5f}, Sphere{{0.5f, 0, -3}, 0.3f}, Sphere{{-0.2f, 0, -1}, 0.1f}}) {
    const Image image = draw_spheres({sphere});
    const float direction = std::atan2(sphere.center.x, -sphere.center.z);
    const float half_angle = std::asin(sphere.radius / length(sphere.center));
    const Run run = covered_columns(image, kSize / 2);
    CHECK(std::fabs(static_cast<float>(run.first) - column(direction - half_angle)) < 1.2f);
    CHECK(std::fabs(static_cast<float>(run.last + 1) - column(direction + half_angle)) < 1.2f);
  }
}

TEST_CASE("an outline is smooth: its pixels are blended by their covered part") {
  const Sphere sphere{{0, 0, -3}, 0.5f};
  const Image image = draw_spheres({sphere});
  int mixed = 0;
  for (int x = 0; x < kSize; ++x) {
    for (int y = 0; y < kSize; ++y) {
      const uint8_t* pixel = image.pixel(x, y);
      mixed += pixel[0] > 215 && pixel[0] < 250;
    }
  }
  const float radius = column(std::asin(0.5f / 3)) - kSize / 2;
  CHECK(mixed > radius);
  CHECK(mixed < 5 * radius);
}

TEST_CASE("a nearer sphere hides a farther one, in whichever order they are drawn") {
  const Sphere near{{0, 0, -2}, 0.3f};
  const Sphere far{{0.05f, 0, -4}, 0.3f};
  CHECK(count_different(draw_spheres({near, far}), draw_spheres({far, near})) == 0);
  const Image both = draw_spheres({near, far});
  const Image alone = draw_spheres({near});
  CHECK(difference(both.pixel(kSize / 2, kSize / 2), alone.pixel(kSize / 2, kSize / 2)) == 0);
}

TEST_CASE("spheres that overlap meet in the plane between them: depth is that of the surface") {
  // A small sphere in the side of a large one shows a cap, although its centre is farther from the viewer.
  Inspection inspection = inspect({{{0, 0, -3}, 0.5f}, {{0.45f, 0, -2.9f}, 0.2f}, {{9, 9, 9}, 0.1f}}, DomainBox{});
  inspection.contacts = {{1, 2}};  // orange: the small one and an invisible one
  const Image image = draw(along_z(inspection), kSize, kSize);
  // In the middle row, the sphere with the smaller near root is visible.
  int wrong = 0;
  for (int x = 0; x < kSize; ++x) {
    const float slope = (2 * (static_cast<float>(x) + 0.5f) / kSize - 1) * std::tan(Camera{}.fov / 2);
    const Vec3 ray = normalize(Vec3(slope, 0.5f * 2 / kSize * std::tan(Camera{}.fov / 2), -1));
    float nearest = INFINITY;
    bool orange = false;
    for (int i = 0; i < 2; ++i) {
      const Vec3 center = inspection.bodies.position_of(i);
      const float r = inspection.bodies.radius_of(i);
      const float b = dot(ray, center);
      const float root = b * b - dot(center, center) + r * r;
      if (root < 0 || b - std::sqrt(root) >= nearest) continue;
      nearest = b - std::sqrt(root);
      orange = i == 1;
    }
    wrong += std::isfinite(nearest) && is_orange(image.pixel(x, kSize / 2 - 1)) != orange;
  }
  CHECK(wrong <= 2);  // at the seam and the outline
}

TEST_CASE("a sphere smaller than a pixel is still visible") {
  for (const float radius : {0.002f, 1e-5f}) {
    const Image alone = draw_spheres({{{0.013f, 0.021f, -3}, radius}});
    int covered = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) covered += !is_ground(alone.pixel(x, y));
    }
    CHECK(covered >= 1);
    CHECK(covered <= 12);
    // Also beside a large sphere, which prevents drawing as points.
    const Sphere large{{0.4f, 0.4f, -3}, 0.3f};
    CHECK(draw_spheres({large, {{-0.513f, -0.4f, -3}, radius}}).pixels != draw_spheres({large}).pixels);
  }
}

TEST_CASE("spheres around and behind the eye leave the picture empty") {
  const Image image = draw_spheres({{{0, 0, 0}, 0.5f}, {{0, 0, 3}, 0.5f}});
  CHECK(is_ground(image.pixel(kSize / 2, kSize / 2)));
}
