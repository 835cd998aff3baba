// SPDX-License-Identifier: MIT
// Broad phases side by side: the same scene at the same time, each with its own tests and contacts.
#include "show/comparison.h"

#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "show/demo_renderer.h"

using namespace ballpit;

namespace {

const std::vector<BroadPhase> kTwo{BroadPhase::brute_force, BroadPhase::linked_cell};

std::string said(const std::function<void()>& action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

Image drawn(Demo& demo, int width, int height) {
  DemoRenderer drawing(width, height, {});
  drawing.draw(demo, {});
  return drawing.renderer().read_pixels();
}

}  // namespace

TEST_CASE("two to four different broad phases can be compared, and nothing else") {
  CHECK(parse_comparison("brute-force,linked-cell") == kTwo);
  CHECK(parse_comparison("sorted-grid,lecture/linked-cell,sort-and-sweep,brute-force").size() == 4);
  const std::string allowed =
      ", allowed two to 4 different ones of brute-force, sort-and-sweep, linked-cell, sorted-grid, "
      "lecture/brute-force, lecture/sort-and-sweep, lecture/linked-cell, with commas between";
  for (const std::string wrong : {"brute-force", "brute-force,brute-force",
                                  "brute-force,sort-and-sweep,linked-cell,sorted-grid,lecture/brute-force"}) {
    CHECK(said([&] { parse_comparison(wrong); }) == "--compare: found " + wrong + allowed);
  }
  CHECK(said([] { parse_comparison("brute-force,auto"); }) == "--compare: found auto" + allowed);
  CHECK(said([] { parse_comparison("brute-force,"); }) == "--compare: found nothing" + allowed);
}

TEST_CASE("a comparison needs a response that has a use for broad phases") {
  Demo exact("gas-thin", {});
  CHECK_THAT(said([&] { exact.compare(kTwo); }), Catch::StartsWith("--response: found event-driven with --compare"));
  CHECK_THAT(said([] { check_compared({{"response", "auto"}}); }), Catch::StartsWith("--response: found auto with"));
  CHECK_THAT(said([] { check_compared({{"broadphase", "auto"}}); }), Catch::StartsWith("--broadphase: found auto"));
  CHECK(said([] { check_compared({{"response", "penalty"}, {"skin", "0.1"}}); }).empty());
}

TEST_CASE("compared methods make the same motion, and each counts its own tests in every step") {
  Demo demo("bouncing-balls", {{"count", "200"}});
  demo.compare({BroadPhase::brute_force, BroadPhase::sort_and_sweep, BroadPhase::linked_cell});
  REQUIRE(demo.view_count() == 3);
  constexpr int64_t kPairs = 200 * 199 / 2;
  CHECK(demo.tests_so_far() == kPairs);
  std::vector<int64_t> sums{0, 0, 0};
  for (size_t k = 0; k < 3; ++k) sums[k] = demo.view_at(k).report().candidates;
  for (int step = 1; step <= 20; ++step) {
    demo.step();
    for (size_t k = 0; k < 3; ++k) sums[k] += demo.view_at(k).report().candidates;
  }
  CHECK(demo.tests_so_far() == 21 * kPairs);
  for (size_t k = 0; k < 3; ++k) {
    CHECK(demo.view_at(k).session.world().steps() == 20);
    CHECK(demo.view_at(k).report().state_hash == demo.report().state_hash);
    CHECK(demo.view_at(k).tests_so_far() == sums[k]);
  }
  CHECK(sums[2] < sums[1]);
  CHECK(sums[1] < sums[0]);
  demo.go_to(7);
  for (size_t k = 0; k < 3; ++k) CHECK(demo.view_at(k).session.world().steps() == 7);
  CHECK(demo.tests_so_far() == 8 * kPairs);
  demo.go_to(20);
  for (size_t k = 0; k < 3; ++k) CHECK(demo.view_at(k).tests_so_far() == sums[k]);
}

TEST_CASE("a method that misses contacts goes its own way beside one that does not") {
  Demo demo("lecture-contacts", {{"cell-size", "0.5"}});
  demo.compare(kTwo);
  CHECK(demo.report().contacts == 4);
  CHECK(demo.view_at(1).report().contacts == 0);
  demo.advance_to(0.5, [] { return false; });
  CHECK(demo.view_at(1).session.time() == demo.session.time());
  CHECK(demo.view_at(1).report().state_hash != demo.report().state_hash);
}

TEST_CASE("keys and panel act on all compared methods, and leave each its own") {
  Demo demo("bouncing-balls", {{"count", "100"}});
  demo.compare(kTwo);
  const auto check = [&](const char* what) {
    CAPTURE(what, demo.message());
    const Session &one = demo.session, &two = demo.view_at(1).session;
    CHECK(one.settings().broadphase == BroadPhase::brute_force);
    CHECK(two.settings().broadphase == BroadPhase::linked_cell);
    CHECK(one.scene_name() == two.scene_name());
    CHECK(one.settings().dt == two.settings().dt);
    CHECK(one.settings().response == two.settings().response);
    CHECK(one.scene().physics.restitution == two.scene().physics.restitution);
    CHECK(one.world().steps() == two.world().steps());
    CHECK(demo.report().state_hash == demo.view_at(1).report().state_hash);
  };
  for (int k = 0; k < 12; ++k) demo.step();
  check("step");
  demo.set("dt", "0.002");
  check("dt");
  for (int k = 0; k < 12; ++k) demo.step();
  demo.set("response", "penalty");
  check("response");
  demo.step();
  Physics physics = demo.session.scene().physics;
  physics.restitution = 0.25;
  demo.set_physics(physics);
  check("physics");
  demo.step();
  demo.return_to(demo.trade_off.trials().front());
  check("trial");
  demo.set("skin", "0.1");
  demo.step();
  demo.step_back();
  check("back");
  demo.restart();
  check("restart");
  demo.load("rain");
  check("load");
  CHECK(demo.session.scene_name() == "rain");
}

TEST_CASE("what a comparison cannot show is refused, and it goes on as it was") {
  Demo demo("bouncing-balls", {{"count", "100"}});
  demo.compare(kTwo);
  demo.step();
  const uint64_t before = demo.report().state_hash;
  demo.set("broadphase", "sorted-grid");
  CHECK_THAT(demo.message(), Catch::StartsWith("--broadphase: found sorted-grid while broad phases are compared"));
  demo.set("response", "event-driven");
  CHECK_THAT(demo.message(), Catch::StartsWith("--response: found event-driven while"));
  demo.choose_cheapest();
  CHECK_FALSE(demo.is_choosing());
  CHECK(demo.report().state_hash == before);
  demo.load("gas-thin");
  CHECK_THAT(demo.message(), Catch::StartsWith("--response: found event-driven"));
  CHECK(demo.session.scene_name() == "bouncing-balls");
  CHECK(demo.session.settings().broadphase == BroadPhase::brute_force);
  CHECK(demo.view_at(1).session.scene_name() == "bouncing-balls");
  CHECK(demo.report().state_hash == demo.view_at(1).report().state_hash);
}

TEST_CASE("views of a comparison do not overlap, fill the picture, and have the layout that shows the scene largest") {
  const DomainBox wide{Vec3(0), Vec3(6, 4, 4)}, tall{Vec3(0), Vec3(1, 4, 1)}, square{Vec3(0), Vec3(5, 5, 0), 2};
  const auto columns_of = [](size_t count, const DomainBox& domain, float aspect) {
    const std::vector<Room> rooms = view_rooms(count, domain, aspect, 0.05f);
    REQUIRE(rooms.size() == count);
    float area = 0;
    size_t columns = 0;
    for (size_t a = 0; a < count; ++a) {
      area += rooms[a].width() * rooms[a].height();
      columns += rooms[a].above == rooms[0].above;
      CHECK(rooms[a].above >= 0.05f);
      for (size_t b = 0; b < a; ++b) {
        const bool beside = rooms[b].left >= 1 - rooms[a].right || rooms[a].left >= 1 - rooms[b].right;
        CHECK((beside || rooms[a].above >= 1 - rooms[b].below));
      }
    }
    const size_t rows = (count + columns - 1) / columns;
    CHECK(area > 0.97f * 0.95f * static_cast<float>(count) / static_cast<float>(columns * rows));
    return columns;
  };
  CHECK(columns_of(2, wide, 16.0f / 9) == 2);
  CHECK(columns_of(2, wide, 9.0f / 16) == 1);
  CHECK(columns_of(3, square, 16.0f / 9) == 3);
  CHECK(columns_of(4, wide, 16.0f / 9) == 4);
  CHECK(columns_of(4, square, 4.0f / 3) == 2);
  CHECK(columns_of(4, tall, 16.0f / 9) == 4);
}

TEST_CASE("each view of a comparison is drawn in its own part of the picture, the same at every run") {
  const GlContext context;
  Demo demo("lecture-contacts", {{"cell-size", "0.5"}}), again("lecture-contacts", {{"cell-size", "0.5"}});
  for (Demo* one : {&demo, &again}) {
    one->compare(kTwo);
    one->view.has_caption = true;
  }
  const Image picture = drawn(demo, 640, 360);
  CHECK(picture.pixels == drawn(again, 640, 360).pixels);
  const auto count = [&](int from, int to, Vec3 color) {
    int found = 0;
    for (int y = 60; y < 300; ++y) {
      for (int x = from; x < to; ++x) {
        const uint8_t* pixel = &picture.pixels[static_cast<size_t>(y * 640 + x) * 4];
        found += length(Vec3(pixel[0], pixel[1], pixel[2]) / 255.0f - color) < 0.02f;
      }
    }
    return found;
  };
  const Vec3 touching = themes().front().contact, resting = themes().front().body;
  CHECK(count(0, 318, touching) > 500);  // brute force finds the contacts, and small cells do not
  CHECK(count(322, 640, touching) == 0);
  CHECK(count(322, 640, resting) > count(0, 318, resting));
}

TEST_CASE("a compared view is titled by its method and counts its tests, times are shown only where they are wanted") {
  Demo demo("bouncing-balls", {{"count", "100"}});
  demo.compare(kTwo);
  demo.step();
  const PageView* page = demo.view_at(1).frame_view(1.5f).page;
  REQUIRE(page);
  CHECK(page->title == "Linked cell");
  CHECK(page->sign == MethodSign::square);
  REQUIRE(page->figures.size() == 2);
  CHECK_THAT(page->figures[0], Catch::Contains(" tests, "));
  CHECK_THAT(page->figures[1], Catch::EndsWith(" tests so far"));
  demo.measures = true;
  demo.touch();
  demo.keep_together();
  page = demo.view_at(1).frame_view(1.5f).page;
  REQUIRE(page->figures.size() == 3);
  CHECK_THAT(page->figures[2], Catch::EndsWith(" ms a step"));
}

TEST_CASE("a view that stops says so and keeps its place in the picture, while the other one goes on") {
  Demo demo("stack", {{"cell-size", "0.5"}, {"max-overlap", "0.05"}});  // small cells miss what carries the spheres
  demo.compare(kTwo);
  Demo& other = demo.view_at(1);
  const Camera before = other.frame_view(0.8f).camera;
  REQUIRE(other.frame_view(0.8f).domain.framed);
  for (int k = 0; k < 240 && other.player.failure().empty(); ++k) demo.step();
  REQUIRE_FALSE(other.player.failure().empty());
  const double stopped = other.session.time();
  for (int k = 0; k < 3; ++k) demo.step();
  CHECK(demo.player.failure().empty());
  CHECK(demo.session.time() > stopped);
  CHECK(other.session.time() == stopped);
  const FrameView view = other.frame_view(0.8f);
  CHECK(view.page->title == "Linked cell: stopped");
  CHECK(demo.frame_view(0.8f).page->title == "Brute force");
  for (const Camera& camera : {view.camera, demo.frame_view(0.8f).camera}) {
    CHECK(camera.eye == before.eye);
    CHECK(camera.fov == before.fov);
    CHECK(camera.shift == before.shift);
  }
  const GlContext context;
  CHECK(drawn(demo, 640, 360).pixels == drawn(demo, 640, 360).pixels);
}
