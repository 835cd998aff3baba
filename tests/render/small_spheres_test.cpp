// SPDX-License-Identifier: MIT
#include "render/small_spheres.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <catch2/catch.hpp>

#include "render/seen_spheres.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

constexpr int kWidth = 320, kHeight = 180;
const DomainBox kBox{Vec3(0), Vec3(3, 2, 2)};

/// Where each is: on a grid whose places are a diameter or more apart, moved at random, so that no two overlap.
std::vector<Sphere> spheres_apart(float radius, float spacing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> shift(radius - spacing / 2, spacing / 2 - radius);
  std::vector<Sphere> spheres;
  for (float x = spacing / 2; x < kBox.max.x; x += spacing) {
    for (float y = spacing / 2; y < kBox.max.y; y += spacing) {
      for (float z = spacing / 2; z < kBox.max.z; z += spacing) {
        const float dx = shift(random), dy = shift(random), dz = shift(random);
        spheres.push_back({{x + dx, y + dy, z + dz}, radius});
      }
    }
  }
  return spheres;
}

SmallSpheres as_arrays(const std::vector<Sphere>& spheres) {
  SmallSpheres result;
  for (const auto& [center, radius] : spheres) {
    for (int axis = 0; axis < 3; ++axis) result.position.push_back(center[axis]);
    result.radius.push_back(radius);
  }
  return result;
}

/// The rays through the pixels, and the nearest sphere that each meets, by the depth of its centre.
std::set<uint32_t> first_on_rays(const std::vector<Sphere>& spheres, const Camera& camera) {
  const Mat4 to_world = inverse(camera.projection() * camera.view());
  const Mat4 to_eye = camera.view();
  std::set<uint32_t> found;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vec4 far = to_world * Vec4((2 * float(x) + 1) / kWidth - 1, (2 * float(y) + 1) / kHeight - 1, 0.9f, 1);
      const Vec3 ray = normalize(Vec3(far) / far.w - camera.eye);
      float nearest = INFINITY;
      uint32_t first = 0;
      for (size_t i = 0; i < spheres.size(); ++i) {
        const Vec3 way = spheres[i].center - camera.eye;
        const float along = dot(way, ray), depth = -(to_eye * Vec4(spheres[i].center, 1)).z;
        if (depth >= nearest || dot(way, way) - along * along > spheres[i].radius * spheres[i].radius) continue;
        nearest = depth;
        first = static_cast<uint32_t>(i);
      }
      if (std::isfinite(nearest)) found.insert(first);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("of spheres in a full box, those that a ray meets first are found, and most others are not") {
  const std::vector<Sphere> spheres = spheres_apart(0.055f, 0.12f);
  const Inspection inspection = inspect(spheres, kBox);
  const FrameView view = view_of(inspection, kBox, float(kWidth) / kHeight);
  const SeenSpheres seen = find_seen(as_arrays(spheres), view, kWidth, kHeight);
  const std::set<uint32_t> found(seen.nearest_first.begin(), seen.nearest_first.end());
  for (const uint32_t first : first_on_rays(spheres, view.camera)) CHECK(found.count(first) == 1);
  CHECK(found.size() < spheres.size() / 2);
  float last = 0;
  for (const uint32_t i : seen.nearest_first) {
    const float depth = -(view.camera.view() * Vec4(spheres[i].center, 1)).z;
    CHECK(depth >= last);
    last = depth - 1e-5f;
  }
}

TEST_CASE("only spheres near the floor have a shadow there, and not where others hide it") {
  const Inspection none = inspect({{{1, 1, 1}, 0.05f}}, kBox);
  const FrameView view = view_of(none, kBox, float(kWidth) / kHeight);
  const auto shadows = [&](const std::vector<Sphere>& spheres) {
    const std::vector<Vec4> shown = find_seen(as_arrays(spheres), view, kWidth, kHeight).near_floor;
    return std::count_if(shown.begin(), shown.end(), [](const Vec4& sphere) { return sphere.w == 0.05f; });
  };
  CHECK(shadows({{{1, 0.1f, 1}, 0.05f}}) == 1);
  CHECK(shadows({{{1, 0.25f, 1}, 0.05f}}) == 0);
  const Vec3 low(1, 0.1f, 1), before = low + 0.3f * (view.camera.eye - low);
  CHECK(shadows({{low, 0.05f}, {before, 0.5f}}) == 0);
  CHECK(shadows({{low, 0.05f}, {before, 0.05f}}) == 1);
}

TEST_CASE("many small spheres look as quads show them, and their order does not matter") {
  std::vector<Sphere> spheres = spheres_apart(0.06f, 0.2f);
  spheres.resize(1500);
  const auto picture = [&](const std::vector<Sphere>& shown) {
    Inspection inspection = inspect(shown, kBox);
    inspection.contacts.clear();
    return draw(view_of(inspection, kBox, float(kWidth) / kHeight), kWidth, kHeight);
  };
  const Image quads = picture(spheres);
  for (int k = 0; k < 600; ++k) spheres.push_back({{0, -100, 0}, 0.06f});  // not in the picture
  const Image points = picture(spheres);
  const Comparison comparison = comparison_of(quads, points);
  CHECK(comparison.is_same());
  CHECK((points.pixels != quads.pixels));  // they are drawn in another way
  std::reverse(spheres.begin(), spheres.end());
  CHECK(count_different(picture(spheres), points) == 0);  // but for the rounding of shadows that overlap
}

TEST_CASE("a small sphere whose centre is beside the picture shows the part that is in it") {
  Camera camera;
  camera.eye = Vec3(0), camera.target = Vec3(0, 0, -1), camera.near = 0.05f, camera.far = 50, camera.aspect = 1;
  constexpr int kSize = 100;
  const float half = 3 * std::tan(camera.fov / 2), radius = 0.2f;  // of the picture at the sphere's distance
  std::vector<Sphere> spheres{{{half + radius / 2, 0, -3}, radius}, {{0, -half - radius / 2, -3}, radius}};
  spheres.resize(2100, {{0, 0, 40}, radius});  // behind the eye
  const Inspection inspection = inspect({spheres.begin(), spheres.end()}, DomainBox{});
  const DomainBox invisible{Vec3(-1, -1, -6), Vec3(1, 1, -5.9f), 3, true};
  FrameView view{inspection, invisible, camera, {}};
  const Image image = draw(view, kSize, kSize);
  const auto is_shown = [&](int x, int y) { return difference(image.pixel(x, y), themes().front().body) < 100; };
  CHECK(is_shown(kSize - 1, kSize / 2));
  CHECK(is_shown(kSize / 2, kSize - 1));
}
