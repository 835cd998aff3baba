// SPDX-License-Identifier: MIT
// A lecture in a window: the presenter's keys, full screen, and the panel, which is hidden at first.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "show/presenter.h"
#include "window/panel.h"
#include "window/scene_window.h"

namespace ballpit {

class LectureWindow;

/// A key of the presenter. Remotes send PageUp, PageDown, F5, Esc and a full stop.
struct PresenterKey {
  int code;               ///< as GLFW has it
  std::string_view name;  ///< as it is printed
  std::string_view help;
  void (*act)(LectureWindow&);
};

std::span<const PresenterKey> presenter_keys();

class LectureWindow final : public SceneWindow {
 public:
  LectureWindow(Window& its_window, Presenter& presenter);

  Presenter& presenter;

  /// Arrow keys move by a phase while Shift is down, else by an operation.
  void move_cursor(int direction);
  void type_digit(int digit) { typed_ = typed_ * 10 % 100000 + digit; }
  void go_to_typed_page();
  void leave();  ///< full screen, then the lecture
  void toggle_panel() override { panel_.is_shown = !panel_.is_shown; }
  void show_keys();
  void change_language();
  void toggle_full_screen() { window.set_full_screen(!window.is_full_screen()); }

 protected:
  Demo& demo() override { return presenter.demo(); }
  FrameView frame_view(float aspect) override { return presenter.frame_view(aspect); }
  void press(int code) override;
  void draw(const WindowEvents& events, float elapsed) override;
  std::string title() override;
  int left() const override { return width_beside(panel_, window.size(), ui_scale()); }
  bool is_busy() const override { return !presenter.is_ready(); }
  bool is_fading() const override { return panel_.is_fading(); }
  void advance(double elapsed) override;
  bool takes_mouse() const override { return panel_.has_mouse(); }
  bool takes_keyboard() const override { return panel_.has_keyboard(); }

 private:
  float ui_scale() const { return presenter.demo().view.ui_scale; }

  Renderer renderer_;
  Panel panel_;
  int typed_ = 0;
  int still_ = 0;  // the page that is not ready, but whose picture is shown
};

}  // namespace ballpit
