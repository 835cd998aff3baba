// SPDX-License-Identifier: MIT
// A panel over a small picture, without a window, and a hand.
#pragma once

#include <string>

#include <catch2/catch.hpp>

#include "render/gl_context.h"
#include "render/renderer.h"
#include "window/panel.h"

namespace ballpit {

class Desk {
 public:
  static constexpr int kWidth = 1280, kHeight = 720;

  explicit Desk(const std::string& scene = "lecture-grid", int width = kWidth, int height = kHeight)
      : demo(scene, {{"threads", "1"}}), renderer(width, height) {
    rest();
  }

  void frame(const PanelInput& input) {
    const int width = renderer.width(), height = renderer.height();
    const int left = width_beside(panel, {width, height}, demo.view.ui_scale);
    renderer.set_options({theme_named(demo.view.theme), 1, left, demo.view.text_scale});
    renderer.draw(demo.frame_view(static_cast<float>(width - left) / static_cast<float>(height)));
    panel.draw(demo, input);
  }
  void rest() {
    frame(PanelInput{});
    frame(PanelInput{});
  }
  /// Whether a tab has an item; opens that tab.
  bool has(const std::string& name) {
    return bring_into_view(panel, name, [this] { frame(PanelInput{}); });
  }
  bool is_enabled(const std::string& name) { return has(name) && panel.items().at(name).is_enabled; }
  void click_at(Vec2 at) {
    for (const bool is_down : {false, true, false}) frame(PanelInput{.mouse = at, .is_down = is_down});
    rest();
  }
  void click(const std::string& name) {
    INFO(name);
    REQUIRE(has(name));
    click_at(panel.items().at(name).middle());
  }

  GlContext context;
  Demo demo;
  Renderer renderer;
  Panel panel{renderer.sheet()};
};

}  // namespace ballpit
