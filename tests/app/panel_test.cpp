// SPDX-License-Identifier: MIT
// The panel without a window: what it shows, and what a hand does on it.
#include "app/panel.h"

#include <catch2/catch.hpp>

#include "core/random.h"
#include "render/gl_context.h"
#include "render/renderer.h"

using namespace ballpit;

namespace {

/// A panel over a small picture, and a hand.
class Desk {
 public:
  explicit Desk(const std::string& scene = "lecture-grid") : demo(scene, {{"threads", "1"}}) { rest(); }

  void frame(const PanelInput& input) {
    renderer.set_options({theme_named(demo.view.theme), 1, Panel::width_in(kWidth, kHeight)});
    renderer.draw(demo.frame_view(1));
    panel.draw(demo, input);
  }
  void rest() {
    frame(PanelInput{});
    frame(PanelInput{});
  }
  bool has(const std::string& name) const { return panel.items().count(name) > 0; }
  void click_at(Vec2 at) {
    for (const bool is_down : {false, true, false}) frame(PanelInput{.mouse = at, .is_down = is_down});
    rest();
  }
  void click(const std::string& name) {
    INFO(name);
    REQUIRE(has(name));
    panel.reveal(name);
    rest();
    click_at(panel.items().at(name).middle());
  }

  static constexpr int kWidth = 1280, kHeight = 720;

  GlContext context;
  Demo demo;
  Renderer renderer{kWidth, kHeight};
  Panel panel{renderer.sheet()};
};

}  // namespace

TEST_CASE("a click on a method's name switches to it, and shows its options alone") {
  Desk desk;
  CHECK(desk.has("cell-size"));
  CHECK_FALSE(desk.has("axis"));
  desk.click("broadphase sort-and-sweep");
  CHECK(desk.demo.session.settings().broadphase == "sort-and-sweep");
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

TEST_CASE("a list offers what goes with the response, and nothing else") {
  Desk desk;
  desk.click("integrator");
  CHECK(desk.has("integrator symplectic-euler"));
  CHECK_FALSE(desk.has("integrator rk4"));
  desk.click_at({800, 600});  // beside it
  desk.click("response");
  desk.click("response penalty");
  CHECK(desk.demo.session.settings().response == "penalty");
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

TEST_CASE("no sequence of clicks and keys at random ends the demonstration") {
  Desk desk;
  Random random(7);
  for (int k = 0; k < 300; ++k) {
    if (random.uniform(0, 1) < 0.3) {
      const auto keys = key_table();
      desk.demo.perform(keys[static_cast<size_t>(random.uniform(0, double(keys.size()) - 1e-9))]);
    } else {
      const auto& items = desk.panel.items();
      auto item = items.begin();
      std::advance(item, static_cast<long>(random.uniform(0, double(items.size()) - 1e-9)));
      const std::string name = item->first;
      if (name == "scene" || name.rfind("scene ", 0) == 0) continue;  // some take long to fill
      desk.panel.reveal(name);
      desk.rest();
      if (!desk.has(name)) continue;
      const ItemRect rect = desk.panel.items().at(name);
      const auto part = [&] { return static_cast<float>(random.uniform(0.02, 0.98)); };
      const Vec2 at = rect.low + Vec2(part(), part()) * (rect.high - rect.low);
      for (const bool is_down : {false, true, false}) desk.frame(PanelInput{.mouse = at, .is_down = is_down});
    }
    desk.demo.advance(0.01, 0.02);
    CAPTURE(k, desk.demo.message());
  }
  desk.rest();
  CHECK(desk.has("pause"));
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
  CHECK(desk.demo.session.settings().response == "penalty");
  desk.click("trial 0");
  CHECK(desk.demo.session.settings().response == "position-based");
  CHECK(desk.demo.trade_off.current() == 0);
  const Vec2 before = desk.panel.items().at("trial 1").middle();
  desk.click("error drift");
  CHECK(desk.panel.items().at("trial 1").middle().y != before.y);
}
