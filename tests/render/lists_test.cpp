// SPDX-License-Identifier: MIT
// What the lists show of each method's own arrays, and what overlays say that have nothing to draw.
#include <catch2/catch.hpp>

#include "render/overlays/overlay.h"
#include "render/painter.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};
constexpr float kAspect = 16.0f / 9;

Inspection three() {
  return inspect({{{0.5f, 0.5f, 0}, 0.1f}, {{4.5f, 1.5f, 0}, 0.1f}, {{2.5f, 3.5f, 0}, 0.1f}}, kPlane, 1);
}

Image lists_of(const Inspection& inspection) { return draw(view_of(inspection, kPlane, kAspect, {"lists"}), 960, 540); }

/// Drawn pixels in the lower part of the picture, left of this column.
int drawn_below(const Image& image, const Image& plain, int from_y, int to_x) {
  int count = 0;
  for (int y = from_y; y < image.height; ++y) {
    for (int x = 0; x < to_x; ++x) count += difference(image.pixel(x, y), plain.pixel(x, y)) > 8;
  }
  return count;
}

}  // namespace

TEST_CASE("a hashed table shows the cell of each body, so that bodies of one slot can be told apart") {
  Inspection inspection = three();
  inspection.grids[0].arrays = CellArrays{false, true, {2, -1, -1, -1}, {-1, 0, 1}};  // all share slot 0
  const Image shared = lists_of(inspection);
  Inspection moved = inspection;
  moved.bodies.position[4] = 0.5f;  // body 2 into another cell of the same slot
  const auto [low, high] = std::pair(shared.height * 2 / 3, shared.width);
  CHECK(drawn_below(lists_of(moved), shared, low, high) > 10);
  inspection.grids[0].arrays->is_hashed = false;
  Inspection dense_moved = moved;
  dense_moved.grids[0].arrays->is_hashed = false;
  CHECK(drawn_below(lists_of(dense_moved), lists_of(inspection), low, high) == 0);
}

TEST_CASE("of a long table, the occupied slots are drawn, not a histogram") {
  Inspection inspection = three();
  CellArrays table{false, true, std::vector<int32_t>(64, -1), {-1, -1, 1}};
  table.cells[9] = 0;
  table.cells[41] = 2;
  inspection.grids[0].arrays = table;
  const Image plain = draw(view_of(inspection, kPlane, kAspect), 960, 540);
  const Image image = lists_of(inspection);
  const float room = room_below({"lists"}, inspection);
  CHECK(room > 0.2f);
  const Image ground = draw({inspection, kPlane, view_of(inspection, kPlane, kAspect, {"lists"}).camera, {}}, 960, 540);
  CHECK(drawn_below(image, ground, 540 - static_cast<int>(room * 540) + 8, 400) > 500);
}

TEST_CASE("every overlay draws something or says in a line why it does not, for every method and in a crowd") {
  std::vector<Sphere> crowd;
  for (int k = 0; k < 3600; ++k) {
    crowd.push_back(
        {{0.05f + 0.08f * static_cast<float>(k % 60), 0.05f + 0.08f * static_cast<float>(k / 60), 0}, 0.03f});
  }
  Inspection sweep = inspect(crowd, kPlane);
  add_endpoints(sweep, 0);
  const std::vector<Inspection> states{inspect(crowd, kPlane), inspect(crowd, kPlane, 0.1f), sweep, three()};
  for (size_t k = 0; k < states.size(); ++k) {
    for (const OverlayEntry& entry : overlay_table()) {
      INFO("state " << k << ", " << entry.name);
      const std::vector<std::string> overlays{std::string(entry.name)};
      const FrameView view = view_of(states[k], kPlane, kAspect, overlays);
      const Image without = draw({states[k], kPlane, view.camera, {}}, 960, 540);
      CHECK(count_different(draw(view, 960, 540), without) > 100);
    }
  }
}

TEST_CASE("a selected sphere's partners include those of missed contacts") {
  Inspection inspection;
  inspection.contacts = {{0, 3}};
  inspection.missed = {{1, 3}, {3, 7}};
  CHECK(touching(inspection, 3) == std::vector<int32_t>{0, 1, 7});
  CHECK(touching(inspection, 7) == std::vector<int32_t>{3});
  CHECK(touching(inspection, 5).empty());
}
