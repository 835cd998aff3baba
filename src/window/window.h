// SPDX-License-Identifier: MIT
// A window with an OpenGL 4.5 context, by GLFW, and its events.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/math.h"
#include "show/options.h"
#include "window/panel.h"

struct GLFWwindow;

namespace ballpit {

/// The events since the last poll(). Positions are in pixels of the framebuffer, from its upper left corner.
struct WindowEvents {
  Vec2 mouse{0.0f};
  bool is_mouse_down = false;  ///< the left button, now
  bool was_pressed = false;    ///< it went down
  bool was_released = false;   ///< it went up
  float wheel = 0;
  std::vector<int> pressed{};  ///< keys that went down, by GLFW's code
  std::vector<int> held{};     ///< keys that the keyboard repeats, since they are down for long
  std::map<int, bool> keys{};  ///< keys that changed, and whether they are down now
  std::u32string typed{};      ///< characters
  bool has_menu = false;       ///< the right button went down
  bool is_shift_down = false;  ///< now, and when the button went down or up
  bool is_ctrl_down = false;   ///< the same
  bool any = false;            ///< anything at all, including a new size or an uncovered window

  /// A click so short that it is over already is down for one frame.
  PanelInput for_panel(float elapsed) const {
    return {mouse, is_mouse_down || was_pressed, wheel, typed, elapsed, keys};
  }
};

class Window {
 public:
  /// Throws UserError for a size far beyond the display, RunError with GLFW's reason without a display or OpenGL 4.5.
  Window(PictureSize size, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool is_to_close() const;

  /// Events since the last call; waits for one for `seconds` at most.
  const WindowEvents& poll(double seconds);

  PictureSize size() const;  ///< [pixel] of the framebuffer; 0 while the window is minimised
  float density() const;     ///< pixels for one of an ordinary display: 2 on many HiDPI displays
  void show();               ///< shows what was drawn
  void set_title(const std::string& title);

  bool is_full_screen() const;
  void set_full_screen(bool is_full);  ///< on the primary display, or at the size and place of before

 private:
  static Window& of(GLFWwindow* window);
  static WindowEvents& changed(GLFWwindow* window);
  void listen();
  Vec2 to_pixels(double x, double y) const;

  GLFWwindow* window_ = nullptr;
  int before_[4] = {0, 0, 0, 0};  // place and size before it filled the screen
  WindowEvents events_;
};

}  // namespace ballpit
