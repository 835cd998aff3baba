// SPDX-License-Identifier: MIT
// Overlays on small pictures, and their counts.
#include "render/overlays/overlay.h"

#include <catch2/catch.hpp>

#include "render/overlays/interval_list.h"
#include "render/page_view.h"
#include "render/painter.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

const DomainBox kPlane{Vec3(0), Vec3(5, 5, 0), 2, false};
constexpr int kSize = 400;
const Theme& kTheme = themes().front();

/// The pixel of a point of the plane in a square picture.
Vec2 place(const FrameView& view, const Vec3& point, int size = kSize) {
  const Vec4 clip = view.camera.projection() * view.camera.view() * Vec4(point, 1);
  return Vec2(1 + clip.x / clip.w, 1 - clip.y / clip.w) / 2.0f * static_cast<float>(size);
}

/// The smallest difference from a colour within a few pixels of a position.
int nearest_difference(const Image& image, Vec2 at, const Vec3& color, int reach) {
  int least = 255;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const int u = std::clamp(static_cast<int>(at.x) + x, 0, image.width - 1);
      const int v = std::clamp(static_cast<int>(at.y) + y, 0, image.height - 1);
      least = std::min(least, difference(image.pixel(u, v), color));
    }
  }
  return least;
}

/// Two discs that touch at (2.5, 2.5), one that does not touch.
Inspection three() { return inspect({{{2, 2.5f, 0}, 0.51f}, {{3, 2.5f, 0}, 0.51f}, {{2.5f, 4.3f, 0}, 0.4f}}, kPlane); }

}  // namespace

TEST_CASE("a missed pair is a double vermillion line, with rings around both spheres") {
  Inspection inspection = three();
  inspection.missed = std::exchange(inspection.contacts, {});
  const FrameView view = view_of(inspection, kPlane, 1, {"pairs"});
  const Image image = draw(view, kSize, kSize);
  const Vec2 middle = place(view, {2.5f, 2.5f, 0});
  CHECK(nearest_difference(image, middle + Vec2(0, 2), kTheme.missed, 1) < 16);
  CHECK(nearest_difference(image, middle - Vec2(0, 2), kTheme.missed, 1) < 16);
  CHECK(nearest_difference(image, place(view, {2, 3.05f, 0}), kTheme.missed, 2) < 16);
  CHECK(nearest_difference(image, place(view, {3, 1.95f, 0}), kTheme.missed, 2) < 16);
  CHECK(nearest_difference(image, place(view, {2.5f, 4.8f, 0}), kTheme.missed, 4) > 60);
}

TEST_CASE("a lane is blue while its thread walks, and grey while it waits for the longest one of its warp") {
  Inspection inspection = three();
  inspection.work = std::vector<int>(64, 2);
  inspection.work[0] = 10;
  const FrameView view = view_of(inspection, kPlane, 1, {"warps"});
  const Image image = draw(view, kSize, kSize);
  const auto walks = [&](float x, float y) {
    return nearest_difference(image, Vec2(x, y) * float(kSize), kTheme.begin, 1) < 16;
  };
  std::vector<float> lanes;  // from left to right, those of the first warp that are blue at a third of their height
  for (int x = 0; x < kSize / 4; ++x) {
    const float at = (static_cast<float>(x) + 0.5f) / kSize;
    if (walks(at, 0.82f)) lanes.push_back(at);
  }
  REQUIRE_FALSE(lanes.empty());
  CHECK(lanes.back() - lanes.front() < 0.015f);  // one lane
  CHECK(walks(lanes.front() + 0.1f, 0.9f));
  CHECK_FALSE(walks(lanes.front() + 0.1f, 0.82f));
}

TEST_CASE("a contact is a bold orange line with a dark core, a candidate apart a thin sky one") {
  Inspection inspection = three();
  add_candidates(inspection);
  const FrameView view = view_of(inspection, kPlane, 1, {"pairs"});
  const Image image = draw(view, kSize, kSize);
  CHECK(nearest_difference(image, place(view, {2.5f, 2.5f, 0}), rim_of(kTheme.contact), 0) < 24);
  CHECK(nearest_difference(image, place(view, {2.25f, 3.4f, 0}), kTheme.candidate, 1) < 50);
  CHECK(nearest_difference(image, place(view, {3.4f, 3.4f, 0}), kTheme.candidate, 4) > 60);
}

TEST_CASE("candidates apart are candidates without contacts, as often as they are tested") {
  Inspection inspection;
  inspection.contacts = {{0, 2}, {1, 4}, {1, 4}};
  inspection.candidates = {{0, 1}, {0, 1}, {0, 2}, {1, 3}, {1, 4}, {1, 4}};
  CHECK(candidates_apart(inspection) == std::vector<Pair>{{0, 1}, {0, 1}, {1, 3}});
}

TEST_CASE("a walk goes from a begin to its end and meets the begins between them") {
  // b0 b1 e0 b2 e2 e1: the thread of body 1 tests 2; that of body 0 tests 1.
  const std::vector<Endpoint> list = {{0, 0, false}, {1, 1, false}, {2, 0, true},
                                      {3, 2, false}, {4, 2, true},  {5, 1, true}};
  CHECK(shown_walk(list, 0).met == std::vector<size_t>{1});
  CHECK(shown_walk(list, 1).met == std::vector<size_t>{3});
  CHECK(shown_walk(list, 2).met.empty());
  CHECK(shown_walk(list, 2).body == 2);
  CHECK(shown_walk(list, -1).body == 0);  // the first with the most tests
  CHECK(shown_walk(list, 7).body == -1);
  CHECK(shown_walk({}, -1).body == -1);
}

TEST_CASE("a page shows no walk before the sweep, one during it, and all when it is over") {
  const std::vector<Endpoint> list = {{0, 0, false}, {1, 1, false}, {2, 0, true},
                                      {3, 2, false}, {4, 2, true},  {5, 1, true}};
  PageView page;
  page.walks = false;
  CHECK(shown_walks(list, -1, &page).empty());
  page.walks = true;
  CHECK(shown_walks(list, 1, &page).size() == 1);
  CHECK(shown_walks(list, -1, nullptr).size() == 1);
  page.has_walked = true;
  const std::vector<Walk> walks = shown_walks(list, -1, &page);
  REQUIRE(walks.size() == 3);
  CHECK(walks[1].met == std::vector<size_t>{3});
  CHECK(shown_walks(list, 1, &page).size() == 1);
}

TEST_CASE("brackets are on the axis at the ends of intervals") {
  Inspection inspection = inspect({{{2, 2.5f, 0}, 1.0f}}, kPlane);
  add_endpoints(inspection, 0);
  const FrameView view = view_of(inspection, kPlane, 1, {"intervals"});
  const Image image = draw(view, kSize, kSize);
  const float staff = place(view, {0, 0, 0}).y + 34.0f / 1080 * kSize;
  for (const float x : {1.0f, 3.0f}) {
    const Vec2 at(place(view, {x, 0, 0}).x, staff - 5);
    CHECK(nearest_difference(image, at, kTheme.begin, 1) < 60);
  }
  CHECK(nearest_difference(image, {place(view, {3.6f, 0, 0}).x, staff - 5}, kTheme.begin, 3) > 60);
  CHECK(nearest_difference(image, {place(view, {0.4f, 0, 0}).x, staff - 5}, kTheme.begin, 3) > 60);
}

TEST_CASE("cells are counted by the length of their list, the last class contains longer ones") {
  const Inspection inspection = inspect(
      {{{0.5f, 0.5f, 0}, 0.1f}, {{0.6f, 0.6f, 0}, 0.1f}, {{0.7f, 0.3f, 0}, 0.1f}, {{4.5f, 1.5f, 0}, 0.1f}}, kPlane, 1);
  CHECK(count_lengths(inspection.grids[0], 4) == std::vector<int>{23, 1, 0, 1, 0});
  CHECK(count_lengths(inspection.grids[0], 2) == std::vector<int>{23, 1, 1});
}

TEST_CASE("ranges of sorted bodies and buckets of a hashed table are counted") {
  Inspection inspection =
      inspect({{{0.5f, 0.5f, 0}, 0.1f}, {{4.5f, 1.5f, 0}, 0.1f}, {{4.6f, 1.5f, 0}, 0.1f}}, kPlane, 1);
  GridInspection& grid = inspection.grids[0];
  grid.arrays = CellArrays{true, false, {0, 0, 2, 2, 3}, {1, 2, 0}};
  CHECK(count_lengths(grid, 4) == std::vector<int>{2, 1, 1, 0, 0});
  grid.arrays = CellArrays{false, true, {-1, 2, -1, -1, -1, -1, -1, -1}, {-1, 0, 1}};  // all share a bucket
  CHECK(count_lengths(grid, 4) == std::vector<int>{7, 0, 0, 1, 0});
}

TEST_CASE("a note reports a grid with too many cells, and its arrays are still drawn") {
  Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 0.1f}}, kPlane, 1);
  GridInspection& grid = inspection.grids[0];
  grid.head.clear();
  grid.next.clear();
  grid.arrays = CellArrays{false, true, {-1, 0, -1, -1}, {-1}};
  for (const OverlayEntry& entry : overlay_table()) {
    if (entry.name == "grid")
      CHECK(entry.lack(inspection) == "this broad phase has too many cells to show; enlarge them");
    if (entry.name == "lists") CHECK(entry.lack(inspection) == "");
  }
  const Image plain = draw(view_of(inspection, kPlane, 1), kSize, kSize);
  CHECK(count_different(draw(view_of(inspection, kPlane, 1, {"grid", "labels", "lists"}), kSize, kSize), plain) > 500);
  CHECK_FALSE(block_around(grid, inspection.bodies, 0));
}

TEST_CASE("the fastest sphere's arrow is a twelfth of the picture long and ends there") {
  Inspection inspection = three();
  inspection.contacts.clear();
  inspection.bodies.velocity = {0, 0, 0, 0, 2, 0};
  const FrameView view = view_of(inspection, kPlane, 1, {"velocity"});
  const Image image = draw(view, kSize, kSize);
  const Vec2 centre = place(view, {2.5f, 4.3f, 0}), tip = centre + Vec2(kSize / 12.0f, 0);
  CHECK(place(view, Vec3(2.5f + 2 * arrow_time(view), 4.3f, 0)).x == Approx(tip.x).margin(0.01));
  const Image plain = draw(view_of(inspection, kPlane, 1), kSize, kSize);
  const auto is_drawn = [&](float x) {
    int count = 0;
    for (int y = -4; y <= 4; ++y) {
      const int u = static_cast<int>(x), v = static_cast<int>(centre.y) + y;
      count += difference(image.pixel(u, v), plain.pixel(u, v)) > 8;
    }
    return count > 0;
  };
  CHECK(is_drawn(centre.x + 3));
  CHECK(is_drawn(tip.x - 2));
  CHECK_FALSE(is_drawn(tip.x + 2));
  CHECK_FALSE(is_drawn(centre.x - 3));
}

TEST_CASE("spheres that are slow for their scene have short arrows, and those at rest none") {
  Inspection inspection = three();
  inspection.contacts.clear();
  inspection.bodies.velocity = {0, 0, 0, 0, 0.00017f, 0};
  FrameView view = view_of(inspection, kPlane, 1, {"velocity"});
  view.typical_speed = 4;
  const Vec2 centre = place(view, {2.5f, 4.3f, 0});
  const Image plain = draw(view_of(inspection, kPlane, 1), kSize, kSize);
  const auto arrow = [&] {
    const Image image = draw(view, kSize, kSize);
    int columns = 0;
    for (int x = static_cast<int>(centre.x); x < kSize; ++x) {
      const int y = static_cast<int>(centre.y);
      columns += difference(image.pixel(x, y), plain.pixel(x, y)) > 8;
    }
    return columns;
  };
  CHECK(arrow() == 0);
  inspection.bodies.velocity[4] = 0.1f;  // a fortieth of the typical speed: half of an arrow
  CHECK(arrow() == Approx(kSize / 24.0).margin(3));
  inspection.bodies.velocity[4] = 1;
  CHECK(arrow() == Approx(kSize / 12.0).margin(3));
}

TEST_CASE("the line of a candidate ends at the surfaces of both spheres") {
  Inspection inspection = inspect({{{1, 2.5f, 0}, 0.6f}, {{4, 2.5f, 0}, 0.6f}}, kPlane);
  inspection.candidates = {{0, 1}};
  const FrameView view = view_of(inspection, kPlane, 1, {"pairs"});
  const Image image = draw(view, kSize, kSize), plain = draw(view_of(inspection, kPlane, 1), kSize, kSize);
  const auto is_drawn = [&](float x) {
    const Vec2 at = place(view, {x, 2.5f, 0});
    return difference(image.pixel(int(at.x), int(at.y)), plain.pixel(int(at.x), int(at.y))) > 8;
  };
  for (const float x : {1.0f, 1.3f, 3.7f, 4.0f}) CHECK_FALSE(is_drawn(x));
  for (const float x : {1.7f, 2.5f, 3.3f}) CHECK(is_drawn(x));
}

TEST_CASE("the line of a candidate across a periodic border leaves the domain and comes back on the other side") {
  Inspection inspection = inspect({{{0.8f, 2.5f, 0}, 0.3f}, {{4.4f, 2.5f, 0}, 0.3f}}, kPlane);
  inspection.candidates = {{0, 1}};
  DomainBox periodic = kPlane;
  periodic.is_periodic = true;
  const FrameView view = view_of(inspection, periodic, 1, {"pairs"});
  const Image image = draw(view, kSize, kSize), plain = draw(view_of(inspection, kPlane, 1), kSize, kSize);
  const auto is_drawn = [&](float x) {
    const Vec2 at = place(view, {x, 2.5f, 0});
    return difference(image.pixel(int(at.x), int(at.y)), plain.pixel(int(at.x), int(at.y))) > 8;
  };
  for (const float x : {0.3f, 4.85f}) CHECK(is_drawn(x));  // from both spheres to the border
  for (const float x : {-0.2f, 2.5f, 5.2f}) CHECK_FALSE(is_drawn(x));
}

TEST_CASE("contacts across a periodic border, found or missed, are drawn at both spheres") {
  Inspection inspection = inspect({{{0.2f, 2.5f, 0}, 0.3f}, {{4.7f, 2.5f, 0}, 0.3f}}, kPlane);
  DomainBox periodic = kPlane;
  periodic.is_periodic = true;
  const bool is_missed = GENERATE(false, true);
  (is_missed ? inspection.missed : inspection.contacts) = {{0, 1}};
  const FrameView view = view_of(inspection, periodic, 1, {"pairs"});
  const Image image = draw(view, kSize, kSize), plain = draw(view_of(inspection, periodic, 1), kSize, kSize);
  for (const float x : {-0.2f, 5.2f}) {  // beyond the border, where the other's image begins
    const Vec2 at = place(view, {x, 2.5f, 0});
    int largest = 0;
    for (int y = -4; y <= 4; ++y) {
      largest =
          std::max(largest, difference(image.pixel(int(at.x), int(at.y) + y), plain.pixel(int(at.x), int(at.y) + y)));
    }
    CAPTURE(x);
    CHECK(largest > 60);
  }
}

TEST_CASE("the candidates of the selected sphere and paths are visible through nearer spheres") {
  const DomainBox box;
  const auto visible = [&](const char* overlay, bool is_selected) {
    const Vec3 eye = view_of(inspect({}, box), box, 1).camera.eye, middle(0.5f), near = normalize(eye - middle);
    const Vec3 across = normalize(glm::cross(near, Vec3(0, 1, 0)));
    const std::vector<Sphere> spheres{
        {middle - 0.3f * across, 0.03f}, {middle + 0.3f * across, 0.03f}, {middle + 0.3f * near, 0.2f}};
    Inspection inspection = inspect(spheres, box);
    inspection.candidates = {{0, 1}};
    for (int axis = 0; axis < 3; ++axis) inspection.bodies.velocity.push_back(0.6f * across[axis]);
    inspection.bodies.velocity.resize(9, 0);
    FrameView view = view_of(inspection, box, 1, {overlay});
    view.selected = is_selected ? 0 : -1;
    view.step = 1;
    const Image plain = draw(view_of(inspection, box, 1), kSize, kSize), image = draw(view, kSize, kSize);
    const Vec2 at = place(view, middle);
    int drawn = 0;
    for (int y = -20; y <= 20; ++y) {  // the border of a path is a radius away from the middle
      const int u = static_cast<int>(at.x), v = static_cast<int>(at.y) + y;
      drawn += difference(image.pixel(u, v), plain.pixel(u, v)) > 8;
    }
    return drawn > 0;
  };
  CHECK_FALSE(visible("pairs", false));
  CHECK(visible("pairs", true));
  CHECK(visible("swept", false));
}

TEST_CASE("many candidates in space are fainter than few, and far ones fainter than near ones") {
  constexpr int kLarge = 1080;
  const DomainBox box;
  const auto darkness = [&](int copies, float z) {
    Inspection inspection = inspect({{{0.3f, 0.5f, z}, 0.05f}, {{0.7f, 0.5f, z}, 0.05f}}, box);
    inspection.candidates = {{0, 1}};
    inspection.bodies.count = 2 + copies;
    for (int k = 0; k < copies; ++k) {  // the others are outside of the picture
      for (const float x : {0.0f, 900.0f, 0.0f}) inspection.bodies.position.push_back(x);
      inspection.bodies.radius.push_back(0.05f);
      if (k > 0) inspection.candidates.push_back({k + 1, k + 2});
    }
    const FrameView view = view_of(inspection, box, 1, {"pairs"});
    const Image image = draw(view, kLarge, kLarge);
    const Vec2 at = place(view, {0.5f, 0.5f, z}, kLarge);
    return nearest_difference(image, at, Vec3(0), 2);
  };
  CHECK(darkness(0, 0.9f) + 20 < darkness(0, 0.1f));
  CHECK(darkness(0, 0.9f) + 20 < darkness(3000, 0.9f));
}

TEST_CASE("a swept way is drawn beside the sphere's path, with a ring at the end of the step") {
  Inspection inspection = three();
  inspection.contacts.clear();
  inspection.bodies.velocity = {0, 0, 0, 0, -8, 0};
  FrameView view = view_of(inspection, kPlane, 1, {"swept"});
  const Image plain = draw(view, kSize, kSize);
  view.step = 0.2f;
  const Image image = draw(view, kSize, kSize);
  CHECK(longest_way(view) == Approx(2));
  const auto is_drawn = [&](float x, float y) {
    const Vec2 at = place(view, {x, y, 0});
    const Vec3& ink = kTheme.text;  // of a line about a pixel wide
    return nearest_difference(image, at, ink, 1) < 120 && nearest_difference(plain, at, ink, 1) > 120;
  };
  for (const float y : {3.9f, 4.7f}) {  // 1.6 m to the left of (2.5, 4.3), 0.4 m on both sides
    CHECK(is_drawn(2.0f, y));
    CHECK(is_drawn(1.2f, y));
    CHECK_FALSE(is_drawn(0.3f, y));
    CHECK_FALSE(is_drawn(2.9f, y));
  }
  CHECK(is_drawn(0.5f, 4.3f));
  CHECK(is_drawn(1.3f, 4.3f));
  CHECK_FALSE(is_drawn(0.3f, 4.3f));
}

TEST_CASE("the block of a sphere is the 3 x 3 cells around its own, within the grid") {
  const Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 0.1f}, {{0.5f, 4.5f, 0}, 0.1f}}, kPlane, 1);
  const GridInspection& grid = inspection.grids[0];
  const auto middle = block_around(grid, inspection.bodies, 0), corner = block_around(grid, inspection.bodies, 1);
  REQUIRE(middle);
  CHECK(middle->low == IVec3(1, 1, 0));
  CHECK(middle->high == IVec3(4, 4, 1));
  REQUIRE(corner);
  CHECK(corner->low == IVec3(0, 3, 0));
  CHECK(corner->high == IVec3(2, 5, 1));

  FrameView view = view_of(inspection, kPlane, 1, {"grid"});
  view.selected = 0;
  const Image image = draw(view, kSize, kSize);
  const Vec3 tint = 0.2f * kTheme.selected + 0.8f * kTheme.background;
  const auto tinted = [&](float x, float y) {
    const Vec2 at = place(view, {x, y, 0});
    return difference(image.pixel(static_cast<int>(at.x), static_cast<int>(at.y)), tint) <= 2;
  };
  CHECK(tinted(1.5f, 1.5f));
  CHECK(tinted(3.5f, 3.5f));
  CHECK_FALSE(tinted(0.5f, 1.5f));
  CHECK_FALSE(tinted(4.5f, 3.5f));
}

TEST_CASE("a sphere that no cell lists has no block") {
  Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 0.1f}}, kPlane, 1);
  inspection.grids[0].head.assign(25, -1);
  CHECK_FALSE(block_around(inspection.grids[0], inspection.bodies, 0));
}

TEST_CASE("overlays without their data draw only a note in the upper left corner") {
  const Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 0.01f}}, kPlane);
  const Image plain = draw(view_of(inspection, kPlane, 1), kSize, kSize);
  for (const char* name : {"intervals", "lists", "velocity", "swept", "grid", "labels", "ghost"}) {
    INFO(name);
    const Image image = draw(view_of(inspection, kPlane, 1, {name}), kSize, kSize);
    int noted = 0, elsewhere = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        (y < 22 ? noted : elsewhere) += difference(image.pixel(x, y), plain.pixel(x, y)) > 8;
      }
    }
    CHECK(noted > 100);
    CHECK(elsewhere == 0);
  }
}

TEST_CASE("the table of overlays gives the reason if a broad phase lacks their data") {
  Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 0.1f}}, kPlane);
  const auto lacks = [&] {
    std::vector<std::string> names;
    for (const OverlayEntry& entry : overlay_table()) {
      if (!entry.lack(inspection).empty()) names.emplace_back(entry.name);
    }
    return names;
  };
  CHECK(lacks() == std::vector<std::string>{"grid", "lists", "intervals", "warps", "ghost"});
  add_endpoints(inspection, 0);
  inspection.work = {1};
  CHECK(lacks() == std::vector<std::string>{"grid", "lists", "ghost"});
  inspection = inspect({{{2.5f, 2.5f, 0}, 0.1f}}, kPlane, 1);
  inspection.ghost.emplace();
  CHECK(lacks() == std::vector<std::string>{"intervals", "warps"});
}

TEST_CASE("notes and strips do not cover each other") {
  Inspection inspection = three();
  add_candidates(inspection);
  add_velocities(inspection, kPlane);
  const Image one = draw(view_of(inspection, kPlane, 3, {"pairs"}), 900, 300);
  const Image two = draw(view_of(inspection, kPlane, 3, {"pairs", "velocity"}), 900, 300);
  // The first line is unchanged; the second one is below it.
  int first = 0, second = 0;
  for (int x = 0; x < 150; ++x) {
    for (int y = 0; y < 14; ++y) first += difference(one.pixel(x, y), two.pixel(x, y)) > 8;
    for (int y = 18; y < 30; ++y) second += difference(one.pixel(x, y), two.pixel(x, y)) > 8;
  }
  CHECK(first == 0);
  CHECK(second > 20);
}

TEST_CASE("numbers are grouped by thousands, and nouns follow them") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1234567) == "1\u2009234\u2009567");
  CHECK(grouped(-1234) == "-1\u2009234");
  CHECK(grouped(-123) == "-123");
  CHECK(counted(1, "contact") == "1 contact");
  CHECK(counted(0, "contact") == "0 contacts");
}

TEST_CASE("thirty thousand candidates are only counted, but contacts are drawn") {
  Inspection inspection = three();
  for (int k = 0; k < 30000; ++k) inspection.candidates.push_back({k, k + 1});
  const FrameView view = view_of(inspection, kPlane, 1, {"pairs"});
  const Image image = draw(view, kSize, kSize);
  CHECK(nearest_difference(image, place(view, {2.5f, 2.5f, 0}), rim_of(kTheme.contact), 0) < 24);
}

TEST_CASE("a page's title is legible in front of spheres") {
  const Inspection inspection = inspect({{{2.5f, 2.5f, 0}, 4}}, kPlane);
  FrameView view = view_of(inspection, kPlane, 1);
  PageView page;
  page.title = ".";
  view.page = &page;
  const Image image = draw(view, kSize, kSize);
  CHECK(difference(image.pixel(kSize / 2, 8), kTheme.background) < 40);
  CHECK(difference(image.pixel(kSize / 2, 40), kTheme.background) > 60);
}
