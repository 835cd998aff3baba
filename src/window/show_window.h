// SPDX-License-Identifier: MIT
// The window of `ballpit show`: a demonstration with its panel, and what it saves.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "show/hand.h"
#include "show/stepping.h"
#include "window/panel.h"
#include "window/saver.h"
#include "window/scene_window.h"

namespace ballpit {

class ShowWindow;

/// A key of the window itself; those of the demonstration: key_table().
struct WindowKey {
  int code;               ///< as GLFW has it
  std::string_view name;  ///< as it is printed
  std::string_view help;
  void (*act)(ShowWindow&);
};

std::span<const WindowKey> window_keys();

/// What the mouse does with Shift and Ctrl, for the list that F1 shows.
std::span<const std::string_view> hand_gestures();

class ShowWindow final : public SceneWindow {
 public:
  ShowWindow(Window& its_window, Demo& demo);

  void save_picture() { saver_.save_picture(window.size()); }
  void toggle_full_screen() { window.set_full_screen(!window.is_full_screen()); }
  void leave();  ///< the kernel's steps, then full screen
  void move_cursor(int direction);
  void toggle_panel() override { panel_.is_shown = !panel_.is_shown; }

 private:
  Demo& demo() override { return demo_; }
  FrameView frame_view(float aspect) override {
    return stepping_.cursor() ? stepping_.frame_view(aspect) : demo_.frame_view(aspect);
  }
  bool is_busy() const override { return saver_.is_filming(); }
  bool is_fading() const override { return panel_.is_fading(); }
  bool takes_mouse() const override { return panel_.has_mouse(); }
  bool takes_keyboard() const override { return panel_.has_keyboard(); }
  void advance(double elapsed) override;
  int left() const override { return width_beside(panel_, window.size(), demo_.view.ui_scale); }
  void press(int code) override;
  bool goes_on(int code) const override;
  void draw(const WindowEvents& events, float elapsed) override;
  std::string title() override;
  void handle(PanelRequests& requests);
  bool can_act();
  bool grab(Vec2 at) override;
  void drag(Vec2 at) override {
    const auto [view, place] = seen_at(at);
    hand_.drag(view, place);
  }
  void let_go(Vec2 at, bool is_click) override;
  void click(Vec2 at) override;

  Demo& demo_;
  DemoRenderer drawing_;
  Panel panel_;
  Saver saver_;
  Stepping stepping_;
  Hand hand_;
};

}  // namespace ballpit
