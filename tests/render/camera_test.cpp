// SPDX-License-Identifier: MIT
#include "render/camera.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

using namespace ballpit;

namespace {

/// Extremes of the projected corners, as fractions of half the picture.
struct Extent {
  float left = 9, right = -9, bottom = 9, top = -9, nearest = 9, farthest = -9;
};

Extent project(const Camera& camera, Vec3 min, Vec3 max) {
  Extent extent;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z);
    const Vec4 clip = camera.projection() * camera.view() * Vec4(corner, 1);
    const Vec3 p = Vec3(clip) / clip.w;
    extent = {std::min(extent.left, p.x), std::max(extent.right, p.x),   std::min(extent.bottom, p.y),
              std::max(extent.top, p.y),  std::min(extent.nearest, p.z), std::max(extent.farthest, p.z)};
  }
  return extent;
}

}  // namespace

TEST_CASE("a box fills the frame up to the margin, centred, at any shape of box and picture") {
  for (const Vec3& max : {Vec3(1, 1, 1), Vec3(5, 1, 1), Vec3(0.1f, 3, 0.2f), Vec3(1, 1, 40)}) {
    for (const float aspect : {16.0f / 9, 1.0f, 9.0f / 16, 4.0f}) {
      const Vec3 min(-0.5f, 2, 1);
      const Extent extent = project(frame_box(min, min + max, 3, aspect), min, min + max);
      CHECK(std::max(extent.right - extent.left, extent.top - extent.bottom) == Approx(2 * 0.88f).epsilon(1e-3));
      CHECK(extent.right == Approx(-extent.left).margin(1e-3));
      CHECK(extent.top == Approx(-extent.bottom).margin(1e-3));
      CHECK(extent.nearest > -1);
      CHECK(extent.farthest < 1);
    }
  }
}

TEST_CASE("room below keeps the view, smaller, in the upper part of the picture") {
  for (const int dimensions : {2, 3}) {
    const Vec3 max(1, 1, dimensions == 3 ? 1 : 0);
    const Camera whole = frame_box(Vec3(0), max, dimensions, 1.5f);
    const Extent before = project(whole, Vec3(0), max);
    const Extent after = project(leave_room_below(whole, 0.2f), Vec3(0), max);
    CHECK(after.right == Approx(0.8f * before.right));
    CHECK(after.top == Approx(0.8f * before.top + 0.2f));
    CHECK(after.bottom == Approx(0.8f * before.bottom + 0.2f));
    CHECK(after.nearest == Approx(before.nearest));
  }
}

TEST_CASE("a planar scene is shown from the front, without perspective") {
  const Camera camera = frame_box(Vec3(1, 2, 0), Vec3(6, 7, 0), 2, 16.0f / 9);
  CHECK(camera.is_orthographic());
  CHECK(camera.pixel_size(3.0f, 100) == camera.pixel_size(30.0f, 100));
  const Extent extent = project(camera, Vec3(1, 2, 0), Vec3(6, 7, 0));
  CHECK(extent.top == Approx(0.88f));
  CHECK(extent.bottom == Approx(-0.88f));
  CHECK(extent.right == Approx(0.88f * 9 / 16));
}
