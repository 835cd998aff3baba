// SPDX-License-Identifier: MIT
// A window that shows a demonstration. The mouse turns the scene, the wheel zooms, a click picks a sphere, and
// the right button hides or shows the panel. With a modifier key, a window may take a drag or a click for itself.
//
//     run():   events ──▶ keys, mouse, panel's input
//              clock ──▶ player: the steps that are due, for half a frame at most
//              anything new? ──▶ draw; else wait for an event
#pragma once

#include <chrono>
#include <string>

#include "show/demo_renderer.h"
#include "window/window.h"

namespace ballpit {

class SceneWindow {
 public:
  explicit SceneWindow(Window& its_window) : window(its_window) {}
  virtual ~SceneWindow() = default;

  /// Until the window is closed, the program is interrupted, or stop() is called.
  void run();

 protected:
  using Clock = std::chrono::steady_clock;

  virtual Demo& demo() = 0;
  virtual void press(int code) = 0;      ///< a key, by GLFW's code
  virtual bool goes_on(int code) const;  ///< whether a key acts again while it is held: those that go step by step
  virtual FrameView frame_view(float aspect) = 0;                    ///< of the scene, with its bodies
  virtual void draw(const WindowEvents& events, float elapsed) = 0;  ///< into the window
  virtual std::string title() = 0;                                   ///< asked once a second
  virtual void toggle_panel() = 0;
  virtual void advance(double elapsed) { demo().advance(elapsed, kFrame / 2); }
  virtual bool is_busy() const { return false; }      ///< whether it works on without events
  virtual bool is_fading() const { return false; }    ///< whether the picture changes without events
  virtual int left() const { return 0; }              ///< [pixel] of the window's width beside the scene
  virtual bool takes_mouse() const { return false; }  ///< whether a panel does
  virtual bool takes_keyboard() const { return false; }

  /// Called when the button goes down; true: the drag is this window's own and does not turn the scene.
  virtual bool grab(Vec2 /*at*/) { return false; }
  virtual void drag(Vec2 /*at*/) {}
  virtual void let_go(Vec2 /*at*/, bool /*is_click*/) {}  ///< a click has not moved
  virtual void click(Vec2 at) { pick(at); }

  /// The scene as it is drawn where a pixel is, and the pixel's place in it: see body_at().
  struct Seen {
    FrameView view;
    Vec2 place;
  };
  Seen seen_at(Vec2 at);
  void pick(Vec2 at);

  void stop() { is_stopped_ = true; }
  bool is_shift_down() const { return is_shift_down_; }
  bool is_ctrl_down() const { return is_ctrl_down_; }

  static constexpr double kFrame = 1.0 / 60;  // [s]

  Window& window;

 private:
  void handle(const WindowEvents& events);

  Vec2 mouse_{0.0f}, pressed_at_{0.0f};
  bool is_turning_ = false, is_settling_ = true, is_stopped_ = false, is_shift_down_ = false, is_ctrl_down_ = false,
       is_grabbing_ = false;
  Demo::Version drawn_;
  Clock::time_point titled_{};
};

}  // namespace ballpit
