// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "render/overlays/overlay.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};

/// The pixel in a quarter of the way into cell (x, y) of a 5 × 5 grid in a square picture, where no disc
/// lies.
const uint8_t* cell_pixel(const Image& image, int x, int y) {
  const float edge = static_cast<float>(image.width) * 0.88f / 5;
  const float margin = static_cast<float>(image.width) * 0.06f;
  return image.pixel(static_cast<int>(margin + (static_cast<float>(x) + 0.15f) * edge),
                     static_cast<int>(margin + (static_cast<float>(4 - y) + 0.85f) * edge));
}

}  // namespace

TEST_CASE("bodies are counted per cell along the lists") {
  const Inspection inspection =
      inspect({{{0.5f, 0.5f, 0}, 0.1f}, {{0.6f, 0.6f, 0}, 0.1f}, {{4.5f, 1.5f, 0}, 0.1f}}, kPlane, 1);
  const std::vector<int> counts = count_per_cell(inspection.grids.at(0));
  REQUIRE(counts.size() == 25);
  CHECK(counts[0] == 2);
  CHECK(counts[9] == 1);
  CHECK(counts[1] == 0);
}

TEST_CASE("a planar grid tints occupied cells only, fuller ones more") {
  const Inspection inspection =
      inspect({{{1.6f, 3.6f, 0}, 0.1f}, {{3.5f, 0.5f, 0}, 0.1f}, {{3.8f, 0.7f, 0}, 0.1f}}, kPlane, 1);
  const Image image = draw(view_of(inspection, kPlane, 1, {"grid"}), 400, 400);
  const Vec3 ground = themes().front().background;
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      const bool occupied = (x == 1 && y == 3) || (x == 3 && y == 0);
      CHECK((difference(cell_pixel(image, x, y), ground) > 8) == occupied);
    }
  }
  CHECK(cell_pixel(image, 3, 0)[0] < cell_pixel(image, 1, 3)[0] - 8);
  const uint8_t* tint = cell_pixel(image, 1, 3);
  CHECK(tint[1] > tint[0] + 8);  // green
}

TEST_CASE("a spatial grid draws edges of occupied cells only, and spheres hide lines behind them") {
  const DomainBox box;
  const Inspection with = inspect({{{0.125f, 0.125f, 0.875f}, 0.1f}}, box, 0.25f);
  const Image plain = draw(view_of(with, box, 16.0f / 9), 320, 180);
  const FrameView view = view_of(with, box, 16.0f / 9, {"grid"});
  const Image image = draw(view, 320, 180);
  const auto place = [&](Vec3 point) {
    const Vec4 clip = view.camera.projection() * view.camera.view() * Vec4(point, 1);
    return IVec3(static_cast<int>((clip.x / clip.w + 1) * 160), static_cast<int>((1 - clip.y / clip.w) * 90), 0);
  };
  const IVec3 middle = place({0.125f, 0.125f, 0.875f});
  int inside = 0;
  int outside = 0;
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      const bool near = std::abs(x - middle.x) < 36 && std::abs(y - middle.y) < 36;
      (near ? inside : outside) += difference(image.pixel(x, y), plain.pixel(x, y)) > 8;
    }
  }
  CHECK(inside > 100);
  CHECK(outside == 0);
  // The cell's farthest corner lies behind the sphere.
  const IVec3 center = place({0.125f, 0.125f, 0.975f});
  CHECK(difference(image.pixel(center.x, center.y), plain.pixel(center.x, center.y)) == 0);
}

TEST_CASE("cells that extend beyond the domain are drawn up to its wall") {
  // Cells of 2 in a square of 5: three along each axis, the last to 6.
  const Inspection inspection = inspect({{{4.5f, 4.5f, 0}, 0.1f}}, kPlane, 2);
  REQUIRE(inspection.grids.at(0).cells.x == 3);
  const Image image = draw(view_of(inspection, kPlane, 1, {"grid"}), 400, 400);
  const Vec3 ground = themes().front().background;
  CHECK(difference(image.pixel(360, 60), ground) > 8);   // inside, in the corner cell
  CHECK(difference(image.pixel(390, 60), ground) <= 8);  // right of the domain
  CHECK(difference(image.pixel(360, 8), ground) <= 8);   // above it
}
