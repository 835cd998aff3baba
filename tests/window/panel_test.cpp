// SPDX-License-Identifier: MIT
// The panel without a window: what it shows, and what a hand does on it.
#include "window/panel.h"

#include <algorithm>

#include <catch2/catch.hpp>
#include <time.h>

#include "tests/support/desk.h"
#include "tests/support/picture_compare.h"

using namespace ballpit;

TEST_CASE("a click on a method's name switches to it, and shows its options alone") {
  Desk desk;
  CHECK(desk.has("cell-size"));
  CHECK_FALSE(desk.has("axis"));
  desk.click("broadphase sort-and-sweep");
  CHECK(desk.demo.session.settings().broadphase == BroadPhase::sort_and_sweep);
  CHECK(desk.has("axis"));
  CHECK_FALSE(desk.has("cell-size"));
  desk.click("broadphase brute-force");
  CHECK_FALSE(desk.has("axis"));
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

TEST_CASE("a list offers what goes with the response, and nothing else") {
  Desk desk;
  desk.click("integrator");
  CHECK(desk.has("integrator symplectic-euler"));
  CHECK_FALSE(desk.has("integrator rk4"));
  desk.click_at({800, 600});  // beside it
  desk.click("response");
  desk.click("response penalty");
  CHECK(desk.demo.session.settings().response == Response::penalty);
  CHECK(desk.has("stiffness"));
  desk.click("integrator");
  CHECK(desk.has("integrator rk4"));
}

TEST_CASE("a slider that is dragged takes effect when it is let go") {
  Desk desk;
  desk.panel.reveal("cell-size");
  desk.rest();
  const ItemRect rect = desk.panel.items().at("cell-size");
  const Vec2 start = rect.middle(), end{rect.low.x + 0.1f * (rect.high.x - rect.low.x), start.y};
  const std::optional<double> before = desk.demo.session.settings().cell_size;
  desk.frame(PanelInput{.mouse = start});
  desk.frame(PanelInput{.mouse = start, .is_down = true});
  desk.frame(PanelInput{.mouse = end, .is_down = true});
  CHECK(desk.demo.session.settings().cell_size == before);
  desk.frame(PanelInput{.mouse = end});
  CHECK(desk.demo.session.settings().cell_size.value() < 1);
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
  desk.click("section Cost");  // fold times, which no two runs have alike
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

#ifndef __SANITIZE_ADDRESS__
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
