// SPDX-License-Identifier: MIT
// The panel's sliders, lists and labels.
#include <algorithm>
#include <set>
#include <thread>

#include <catch2/catch.hpp>

#include "tests/support/desk.h"
#include "tests/support/in_german.h"
#include "window/window.h"

using namespace ballpit;

TEST_CASE("a list offers what goes with the response, and nothing else") {
  Desk desk;
  desk.click("integrator");
  CHECK(desk.has("integrator symplectic-euler"));
  CHECK_FALSE(desk.has("integrator rk4"));
  desk.click_at({800, 600});  // beside it
  desk.click("response");
  desk.click("response penalty");
  CHECK(desk.demo.session.settings().response == Response::penalty);
  CHECK(desk.is_enabled("stiffness"));
  desk.click("integrator");
  CHECK(desk.has("integrator rk4"));
}

TEST_CASE("a slider acts while it is dragged, and stops at the values that people want") {
  Desk desk;
  REQUIRE(desk.has("cell-size"));
  const ItemRect rect = desk.panel.items().at("cell-size");
  const auto at = [&](float part) { return Vec2(rect.low.x + part * (rect.high.x - rect.low.x), rect.middle().y); };
  desk.frame(PanelInput{.mouse = at(0.5f)});
  desk.frame(PanelInput{.mouse = at(0.5f), .is_down = true});
  std::set<double> reached;
  for (int k = 0; k <= 200; ++k) {
    desk.frame(PanelInput{.mouse = at(0.005f * float(k)), .is_down = true});
    reached.insert(desk.demo.session.settings().cell_size.value());
  }
  for (const double wanted : {0.5, 1.0, 2.0, 4.0, 8.0}) CHECK(reached.contains(wanted));
  desk.frame(PanelInput{.mouse = at(1)});
  CHECK(desk.demo.session.settings().cell_size.value() == 8);
}

TEST_CASE("Ctrl and a click let a number be typed into a slider, and change nothing before it is entered") {
  constexpr int kCtrl = 341, kEnter = 257;
  Desk desk;
  REQUIRE(desk.has("cell-size"));
  const Vec2 at = desk.panel.items().at("cell-size").middle();
  const std::optional<double> before = desk.demo.session.settings().cell_size;
  desk.frame(PanelInput{.mouse = at, .keys = {{kCtrl, true}}});
  desk.frame(PanelInput{.mouse = at, .is_down = true});
  desk.frame(PanelInput{.mouse = at, .keys = {{kCtrl, false}}});
  CHECK(desk.demo.session.settings().cell_size == before);
  CHECK(desk.panel.has_keyboard());
  desk.frame(PanelInput{.typed = U"1.25"});
  CHECK(desk.demo.session.settings().cell_size == before);
  for (const bool is_down : {true, false}) desk.frame(PanelInput{.keys = {{kEnter, is_down}}});
  CHECK(desk.demo.session.settings().cell_size == 1.25);
}

TEST_CASE("Tab, which hides the panel, goes to a slider only while a number is typed into another") {
  constexpr int kCtrl = 341, kTab = 258;
  Desk desk;
  const auto press_tab = [&] {
    for (const bool is_down : {true, true, false}) desk.frame(PanelInput{.keys = {{kTab, is_down}}});
  };
  desk.click("tab Method");  // the panel has ImGui's focus
  press_tab();
  press_tab();
  CHECK_FALSE(desk.panel.has_keyboard());
  REQUIRE(desk.has("cell-size"));
  const Vec2 at = desk.panel.items().at("cell-size").middle();
  desk.frame(PanelInput{.mouse = at, .keys = {{kCtrl, true}}});
  desk.frame(PanelInput{.mouse = at, .is_down = true});
  desk.frame(PanelInput{.mouse = at, .keys = {{kCtrl, false}}});
  REQUIRE(desk.panel.has_keyboard());
  press_tab();
  CHECK(desk.panel.has_keyboard());
}

TEST_CASE("a click that is over within a frame counts") {
  Desk desk;
  REQUIRE(desk.has("overlay pairs"));
  WindowEvents events{.mouse = desk.panel.items().at("overlay pairs").middle()};
  desk.frame(events.for_panel(0.016f));
  events.was_pressed = events.was_released = true;  // both since the frame before
  desk.frame(events.for_panel(0.016f));
  events.was_pressed = events.was_released = false;
  desk.frame(events.for_panel(0.016f));
  CHECK(desk.demo.view.shows("pairs"));
}

TEST_CASE("numbers of settings are written as people write them") {
  Desk desk;
  const auto shown = [&](std::string_view name) {
    const auto& table = setting_table();
    const auto info = std::ranges::find(table, name, &SettingInfo::name);
    return shown_value(*info, info->in_use(desk.demo.session.settings()), desk.demo.session.world().shape());
  };
  CHECK(shown("dt") == "4.17 ms");
  CHECK(shown("cell-size") == "2 × 2r = 1 m");
  CHECK(shown("threads") == "1");
  desk.demo.set("threads", "0");
  CHECK(shown("threads") == fmt::format("all ({})", std::thread::hardware_concurrency()));
}

TEST_CASE("no label of the panel is cut off, at any scale, in both languages") {
  std::optional<InGerman> in_german;
  if (GENERATE(false, true)) in_german.emplace();
  for (const float scale : {0.5f, 1.0f, 2.0f, 3.0f}) {
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}}) {
      Desk desk("lecture-grid", width, height);
      desk.demo.view.ui_scale = scale;
      const auto right = float(Panel::width_in(width, height, scale));
      for (const PanelTab tab : kPanelTabs) {
        desk.panel.open(tab);
        desk.rest();
        desk.rest();
        for (const auto& [name, rect] : desk.panel.items()) {
          if (name == "card" || name.starts_with("tab ")) continue;
          CAPTURE(scale, width, name);
          CHECK(rect.high.x <= right);
        }
      }
    }
  }
}
