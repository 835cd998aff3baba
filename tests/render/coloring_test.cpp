// SPDX-License-Identifier: MIT
// The colours of spheres.
#include "render/coloring.h"

#include <catch2/catch.hpp>

#include "core/error.h"
#include "render/notes_room.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_scenes.h"

using namespace ballpit;

namespace {

/// Four spheres in two cells, as linked cells list them: cell 0 holds 3 → 1 → 0, cell 1 holds 2.
Inspection four() {
  Inspection inspection;
  inspection.bodies.count = 4;
  inspection.bodies.position = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0};
  inspection.bodies.velocity = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 4};
  inspection.bodies.radius = {0.1f, 0.2f, 0.3f, 0.5f};
  inspection.contacts = {{0, 1}, {0, 3}};
  GridInspection grid;
  grid.cells = {2, 1, 1};
  grid.head = {3, 2};
  grid.next = {-1, 0, -1, 1};
  inspection.grids = {grid};
  inspection.work = {2, 0, 8, 0, 4};  // as the sweep's threads, one of them without work
  inspection.worker = {1, 0, 3, -1, 2};
  return inspection;
}

std::vector<int> steps(const std::string& name) {
  std::vector<int> result;
  for (const Mark mark : coloring_named(name).color(four()).marks) result.push_back(static_cast<int>(mark) - 2);
  return result;
}

/// The view in a colouring, with room for the legend.
FrameView with_legend(const Inspection& inspection, const DomainBox& box, const char* coloring) {
  constexpr float kAspect = 16.0f / 9;
  FrameView view = view_of(inspection, box, kAspect);
  view.coloring = coloring;
  view.notes = notes_room(view, 1, 0);
  const Room room{.above = view.notes.above};
  view.camera = leave_room(frame_box(box.min, box.max, 3, kAspect / room.height()), room, kAspect);
  return view;
}

}  // namespace

TEST_CASE("a quantity's smallest and largest values have the colours at the ends of the scale") {
  CHECK(steps("speed") == std::vector<int>{0, 4, 8, 15});
  CHECK(steps("size") == std::vector<int>{0, 4, 8, 15});
  const Colored speed = coloring_named("speed").color(four());
  CHECK(speed.low == "0 m/s");
  CHECK(speed.high == "4 m/s");
}

TEST_CASE("counts have a colour for each whole number up to the largest") {
  CHECK(steps("contacts") == std::vector<int>{15, 7, 0, 7});
  CHECK(steps("cell") == std::vector<int>{15, 15, 0, 15});
  CHECK(steps("list") == std::vector<int>{15, 7, 0, 0});
  CHECK(steps("work") == std::vector<int>{0, 3, 7, 15});
}

TEST_CASE("spheres at rest, of one size, or none at all have a colour") {
  Inspection still = four();
  still.bodies.velocity.assign(12, 0);
  still.bodies.radius = {0.1f};
  for (const ColoringEntry& entry : coloring_table()) {
    CHECK(entry.color(still).marks.size() == 4);
    CHECK(entry.color(Inspection{}).marks.empty());
  }
}

TEST_CASE("a method without cells or threads colours no sphere by them, and the legend gives the reason") {
  Inspection bare = four();
  bare.grids.clear();
  bare.work.clear();
  for (const char* name : {"cell", "list", "work"}) {
    const Colored colored = coloring_named(name).color(bare);
    CHECK(colored.marks == std::vector<Mark>(4, Mark::none));
    CHECK_THAT(colored.lacking, Catch::Contains("this method has no"));
    CHECK(coloring_named(name).color(four()).lacking.empty());
  }
}

TEST_CASE("the colouring by contact marks spheres, and has no scale") {
  const Colored colored = coloring_named("contact").color(four());
  CHECK(colored.marks == std::vector<Mark>{Mark::contact, Mark::contact, Mark::none, Mark::contact});
  CHECK(colored.low.empty());
}

TEST_CASE("the scale becomes lighter from step to step, in both themes") {
  for (const Theme& theme : themes()) {
    float before = -1;
    for (int k = 0; k < kScaleColors; ++k) {
      const float light = dot(color_of(theme, static_cast<int>(scale_mark(k))), Vec3(0.2126f, 0.7152f, 0.0722f));
      CHECK(light > before);
      before = light;
    }
  }
}

TEST_CASE("an unknown colouring is refused with the names of all") {
  CHECK_THROWS_WITH(coloring_named("mood"), Catch::Contains("contact, speed, size, contacts, cell, list, work"));
}

TEST_CASE("golden: a cloud coloured by radius, speed and work, with legends, and by a quantity that the method lacks") {
  const DomainBox box;
  Inspection cloud = inspect(read_spheres(BALLPIT_GOLDEN_FOLDER "/cloud.csv"), box);
  const auto drawn = [&](const char* coloring, const char* theme) {
    return draw(with_legend(cloud, box, coloring), 640, 360, {theme_named(theme), 1});
  };
  CHECK(compare_with_golden("color_size", drawn("size", "projector")) == "");
  cloud.bodies.velocity = cloud.bodies.position;
  CHECK(compare_with_golden("color_speed_dark", drawn("speed", "dark")) == "");
  for (int32_t i = 0; i < static_cast<int32_t>(cloud.bodies.count); ++i) {  // as brute force: 0 walks furthest
    cloud.work.push_back(static_cast<int>(cloud.bodies.count) - 1 - i);
    cloud.worker.push_back(i);
  }
  CHECK(compare_with_golden("color_work", drawn("work", "projector")) == "");
  cloud.work.clear();
  CHECK(compare_with_golden("color_lacking_dark", drawn("work", "dark")) == "");
}

TEST_CASE("a long name of a colouring ends with its scale, at the margin, however large the text is") {
  Inspection cloud = inspect({{Vec3(0.5f), 0.1f}}, DomainBox{});
  cloud.work = {3};
  cloud.worker = {0};
  FrameView view = view_of(cloud, DomainBox{}, 1.6f);
  view.coloring = "work";
  const Image image = draw(view, 640, 400, {.theme = themes().front(), .text_scale = 1.6f});
  for (int y = 0; y < 60; ++y) {
    for (int x = image.width - 6; x < image.width; ++x) REQUIRE(difference(image.pixel(x, y), Vec3(1)) < 8);
  }
}
