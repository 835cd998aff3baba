// SPDX-License-Identifier: MIT
// The panel without a window: what it shows, and what a hand does on it.
#include "window/panel.h"

#include <algorithm>
#include <set>
#include <thread>

#include <catch2/catch.hpp>
#include <time.h>

#include "tests/support/desk.h"
#include "tests/support/picture_compare.h"
#include "window/window.h"

using namespace ballpit;

TEST_CASE("a click on a method's name switches to it, and its options alone can be set") {
  Desk desk;
  CHECK(desk.is_enabled("cell-size"));
  CHECK_FALSE(desk.is_enabled("axis"));
  desk.click("broadphase sort-and-sweep");
  CHECK(desk.demo.session.settings().broadphase == BroadPhase::sort_and_sweep);
  CHECK(desk.is_enabled("axis"));
  CHECK_FALSE(desk.is_enabled("cell-size"));
  desk.click("broadphase brute-force");
  CHECK_FALSE(desk.is_enabled("axis"));
  desk.click("broadphase lecture/linked-cell");
  CHECK(desk.demo.session.settings().broadphase == BroadPhase::lecture_linked_cell);
}

TEST_CASE("nothing in the panel moves when the method changes") {
  Desk desk;
  REQUIRE(desk.has("broadphase brute-force"));
  const auto before = desk.panel.items();
  for (const char* method : {"sort-and-sweep", "brute-force", "sorted-grid", "lecture/sort-and-sweep"}) {
    desk.click(std::string("broadphase ").append(method));
    for (const auto& [name, rect] : before) {
      CAPTURE(method, name);
      CHECK(desk.panel.items().at(name).low == rect.low);
    }
  }
}

TEST_CASE("overlays, pause, step and theme answer to clicks") {
  Desk desk;
  desk.click("overlay pairs");
  CHECK(desk.demo.view.shows("pairs"));
  desk.click("overlay pairs");
  CHECK_FALSE(desk.demo.view.shows("pairs"));
  desk.click("step");
  CHECK_FALSE(desk.demo.player.is_running);
  CHECK(desk.demo.timeline->step_now() == 1);
  desk.click("back");
  CHECK(desk.demo.timeline->step_now() == 0);
  desk.click("pause");
  CHECK(desk.demo.player.is_running);
  desk.click("theme");
  desk.click("theme dark");
  CHECK(desk.demo.view.theme == "dark");
}

TEST_CASE("the panel says which overlays the broad phase gives nothing to draw") {
  Desk desk;
  desk.click("overlay intervals");
  CHECK(desk.has("lack of intervals"));
  CHECK_FALSE(desk.has("lack of grid"));
  desk.click("broadphase sort-and-sweep");
  CHECK_FALSE(desk.has("lack of intervals"));
  CHECK(desk.has("lack of grid"));
  CHECK_FALSE(desk.has("lack of lists"));  // not asked for
}

TEST_CASE("a hidden panel leaves a button that shows it again, and the whole picture to the scene") {
  Desk desk;
  desk.panel.is_shown = false;
  desk.rest();
  CHECK(width_beside(desk.panel, {1280, 720}, 1) == 0);
  CHECK_FALSE(desk.panel.items().contains("pause"));
  for (const float x : {300.0f, 301.0f}) desk.frame(PanelInput{.mouse = {x, 300}});
  desk.click_at(desk.panel.items().at("panel").middle());
  CHECK(desk.panel.is_shown);
  CHECK(desk.panel.items().contains("pause"));
}

TEST_CASE("the button of a hidden panel goes when the pointer rests, so that it covers no page") {
  Desk desk;
  desk.panel.is_shown = false;
  desk.frame(PanelInput{.mouse = {300, 300}});
  CHECK(desk.panel.items().contains("panel"));
  CHECK(desk.panel.is_fading());
  desk.frame(PanelInput{.mouse = {300, 300}, .elapsed = 5});
  desk.frame(PanelInput{.mouse = {300, 300}});
  CHECK_FALSE(desk.panel.items().contains("panel"));
  CHECK_FALSE(desk.panel.is_fading());
  desk.frame(PanelInput{.mouse = {310, 300}});
  CHECK(desk.panel.items().contains("panel"));
  const float middle = desk.panel.items().at("panel").middle().y / Desk::kHeight;
  CHECK(middle > 0.2);  // below a page's title
  CHECK(middle < 0.8);
}

TEST_CASE("a lecture's pages are in a list of the panel") {
  Desk desk;
  int chosen = 0;
  desk.panel.pages = {{"First", "Second", "Third"}, 2, [&](int number) { chosen = number; }};
  desk.click("page");
  desk.click_at(desk.panel.items().at("page 3").middle());
  CHECK(chosen == 3);
}

TEST_CASE("a key or a page chosen in the panel acts when the panel no longer needs the demonstration") {
  // A lecture's page replaces it. "tab Numbers" is drawn after keys and pages.
  Desk desk;
  int acts = 0;
  const auto act = [&] {
    ++acts;
    CHECK(desk.panel.items().contains("tab Numbers"));
  };
  desk.panel.keys = {{"N", "next", act}};
  desk.panel.pages = {{"First", "Second"}, 1, [&](int) { act(); }};
  desk.click("key N");
  desk.click("page");
  desk.click_at(desk.panel.items().at("page 2").middle());
  CHECK(acts == 2);
}

TEST_CASE("a hint goes after some seconds, or after the first act") {
  Desk desk;
  desk.panel.hint("Space: play");
  desk.frame(PanelInput{.elapsed = 0.1f});
  CHECK(desk.panel.items().contains("hint"));
  SECTION("after seconds") { desk.frame(PanelInput{.elapsed = 15}); }
  SECTION("after an act") {
    desk.panel.end_hint();
    desk.frame(PanelInput{.elapsed = 1.1f});
  }
  desk.frame(PanelInput{});
  CHECK_FALSE(desk.panel.is_fading());
  CHECK_FALSE(desk.panel.items().contains("hint"));
}

TEST_CASE("the list of keys is in the panel, and leaves the scene free") {
  Desk desk;
  desk.panel.keys = {{"Space", "pause, or go on"}};
  desk.demo.shows_keys = true;
  desk.rest();
  REQUIRE(desk.panel.items().contains("close keys"));
  CHECK(desk.panel.items().at("close keys").high.x <= float(Panel::width_in(Desk::kWidth, Desk::kHeight)));
  desk.click_at(desk.panel.items().at("close keys").middle());
  CHECK_FALSE(desk.demo.shows_keys);
}

TEST_CASE("the card of the picked sphere does not cover it") {
  Desk desk;
  for (int32_t i = 0; i < 20; ++i) {
    desk.demo.view.selected = i;
    desk.demo.touch();
    desk.rest();
    const float left = float(Panel::width_in(Desk::kWidth, Desk::kHeight)), width = float(Desk::kWidth) - left;
    const FrameView view = desk.demo.frame_view(width / float(Desk::kHeight));
    const Vec4 place = view.camera.projection() * view.camera.view() * Vec4(view.inspection.bodies.position_of(i), 1);
    const Vec2 at(left + 0.5f * width * (1 + place.x / place.w), 0.5f * float(Desk::kHeight) * (1 - place.y / place.w));
    const ItemRect& card = desk.panel.items().at("card");
    CAPTURE(i, at.x, at.y);
    CHECK_FALSE((card.low.x <= at.x && at.x <= card.high.x && card.low.y <= at.y && at.y <= card.high.y));
  }
}

TEST_CASE("the panel shows what the method stores of the picked sphere") {
  Desk desk;
  CHECK_FALSE(desk.has("row place"));
  desk.demo.view.selected = 0;
  desk.demo.touch();
  desk.rest();
  for (const char* row :
       {"row place", "row touches", "row candidates", "row cell", "row its list", "row place in it"}) {
    CHECK(desk.has(row));
  }
  CHECK_FALSE(desk.has("row interval"));
  desk.click("broadphase sorted-grid");
  CHECK(desk.has("row its range"));
  CHECK_FALSE(desk.has("row its list"));
  desk.click("broadphase sort-and-sweep");
  CHECK(desk.has("row interval"));
  CHECK(desk.has("row in the sorted list"));
  CHECK_FALSE(desk.has("row cell"));
  desk.click("broadphase brute-force");
  CHECK_FALSE(desk.has("row interval"));
  CHECK_FALSE(desk.has("row cell"));
  CHECK(desk.has("row candidates"));
}

TEST_CASE("what is to be exported is asked for by clicks") {
  Desk desk;
  desk.click("save state");
  CHECK(desk.panel.requests.state);
  CHECK_FALSE(desk.panel.requests.picture);
  desk.click("save");
  CHECK(desk.panel.requests.picture);
  desk.click("film size");
  desk.click("film size 640x360");
  CHECK(desk.panel.requests.film_size == "640x360");
  CHECK_FALSE(desk.panel.requests.film);
  desk.click("film");
  CHECK(desk.panel.requests.film);
}

TEST_CASE("the history is that of the steps up to the present one, also after going back") {
  Desk desk;
  for (int k = 0; k < 30; ++k) {
    desk.demo.step();
    desk.rest();
  }
  REQUIRE(desk.demo.history().size() == 31);
  CHECK(desk.demo.history().back().step == 30);
  CHECK(desk.demo.history().front().energy_drift == 0);
  desk.demo.go_to(12);
  desk.rest();
  CHECK(desk.demo.history().size() == 13);
  CHECK(desk.demo.history().back().step == 12);
  desk.click("broadphase brute-force");
  CHECK(desk.demo.history().size() == 13);  // the motion goes on
  desk.demo.set("dt", "0.001");
  CHECK(desk.demo.history().size() == 1);
}

TEST_CASE("the panel grows with its scale, and leaves half of a picture to the scene at least") {
  Desk desk;
  const auto height = [&] {
    const ItemRect rect = desk.panel.items().at("pause");
    return rect.high.y - rect.low.y;
  };
  const float before = height();
  desk.demo.view.ui_scale = 2;
  desk.rest();
  CHECK(height() == Approx(2 * before).epsilon(0.1));
  desk.click("broadphase brute-force");  // items lie where they are drawn
  CHECK(desk.demo.session.settings().broadphase == BroadPhase::brute_force);
  desk.demo.view.ui_scale = 0.5f;
  desk.rest();
  CHECK(height() < 0.8f * before);
  CHECK(Panel::width_in(1920, 1080, 3) == 960);
  CHECK(Panel::width_in(1920, 1080, 0.5f) == 235);
}

TEST_CASE("another scene is chosen from the list") {
  Desk desk;
  desk.click("scene");
  desk.click("scene two-spheres");
  CHECK(desk.demo.session.scene().name == "two-spheres");
}

TEST_CASE("the panel leaves two thirds of a picture to the scene") {
  CHECK(Panel::width_in(1920, 1080) <= 640);
  CHECK(Panel::width_in(300, 1080) == 100);
}

TEST_CASE("golden: the panel in both themes, as it begins and with a picked sphere") {
  Desk desk("lecture-grid", 1024, 720);
  for (int k = 0; k < 60; ++k) {
    desk.demo.step();
    (void)desk.demo.report();  // a point of the histories each
  }
  for (const char* theme : {"projector", "dark"}) {
    desk.demo.view.theme = theme;
    desk.demo.view.selected = -1;
    desk.demo.touch();
    desk.panel.reveal("scene");
    desk.rest();
    desk.rest();
    CHECK(compare_with_golden(std::string("panel_").append(theme), desk.renderer.read_pixels()) == "");
    desk.demo.view.selected = 9;
    desk.demo.touch();
    desk.rest();
    desk.panel.reveal("row place");
    desk.rest();
    desk.rest();
    CHECK(compare_with_golden(std::string("panel_picked_").append(theme), desk.renderer.read_pixels()) == "");
  }
}

TEST_CASE("a click on a point of the chart returns to its settings") {
  Desk desk("stack");
  const auto play = [&] {
    for (int k = 0; k < 20; ++k) {
      desk.demo.step();
      desk.demo.report();
    }
  };
  play();
  desk.demo.set("response", "penalty");
  play();
  desk.rest();
  REQUIRE(desk.has("trial 1"));
  CHECK(desk.demo.session.settings().response == Response::penalty);
  desk.click("trial 0");
  CHECK(desk.demo.session.settings().response == Response::position_based);
  CHECK(desk.demo.trade_off.current() == 0);
  const Vec2 before = desk.panel.items().at("trial 1").middle();
  desk.click("error drift");
  CHECK(desk.panel.items().at("trial 1").middle().y != before.y);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("a frame of the panel takes at most 4 ms of the processor") {
  Desk desk("bouncing-balls");
  const auto spent = [] {  // [ms] by this thread; llvmpipe fills its pixels in others
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
  };
  std::vector<double> frames;
  for (int k = 0; k < 30; ++k) {
    desk.demo.step();
    desk.demo.report();
    glFinish();
    const double before = spent();
    desk.panel.draw(desk.demo, PanelInput{});
    glFinish();
    frames.push_back(spent() - before);
  }
  std::nth_element(frames.begin(), frames.begin() + 15, frames.end());
  CHECK(frames[15] < 4);
}
#endif
