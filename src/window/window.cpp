// SPDX-License-Identifier: MIT
#include "window/window.h"

#include <algorithm>

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "render/gl_context.h"

namespace ballpit {

namespace {

std::string glfw_reason() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  return reason ? reason : "unknown";
}

/// What to do without a window.
std::string alternative() {
  const std::string trouble = trouble_with(kEglLibrary);
  return trouble.empty() ? "ballpit render draws without a display"
                         : "ballpit render would draw without a display, but " + trouble;
}

/// A window much larger than its display is a mistake, and would take too much memory.
void check_size(PictureSize size) {
  constexpr int kMaxDisplays = 4;  // side by side
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (!mode) return;
  const int max_width = kMaxDisplays * mode->width, max_height = kMaxDisplays * mode->height;
  if (size.width <= max_width && size.height <= max_height) return;
  glfwTerminate();
  throw UserError("--size", text_of(size), fmt::format("at most {}x{} on this display", max_width, max_height));
}

}  // namespace

Window::Window(PictureSize size, const std::string& title) {
  const std::string trouble = trouble_with(kGlLibrary);
  if (!trouble.empty()) throw RunError("show", "no window: " + trouble);
  if (!glfwInit()) throw RunError("show", "no window: " + glfw_reason(), alternative());
  check_size(size);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);  // so that a loss is reported
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = glfw_reason();
    glfwTerminate();
    throw RunError("show", "no window with OpenGL 4.5: " + reason, alternative());
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  enable_gl_debug();
  listen();
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Window& Window::of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

WindowEvents& Window::changed(GLFWwindow* window) {
  of(window).events_.any = true;
  return of(window).events_;
}

void Window::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetCursorPosCallback(window_,
                           [](GLFWwindow* w, double x, double y) { changed(w).mouse = of(w).to_pixels(x, y); });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int modifiers) {
    WindowEvents& events = changed(w);
    events.is_shift_down = (modifiers & GLFW_MOD_SHIFT) != 0;
    events.is_ctrl_down = (modifiers & GLFW_MOD_CONTROL) != 0;
    if (button == GLFW_MOUSE_BUTTON_RIGHT && action == GLFW_PRESS) events.has_menu = true;
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    events.is_mouse_down = action == GLFW_PRESS;
    (events.is_mouse_down ? events.was_pressed : events.was_released) = true;
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) { changed(w).wheel += static_cast<float>(y); });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
    WindowEvents& events = changed(w);
    if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT) events.is_shift_down = action != GLFW_RELEASE;
    if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL) events.is_ctrl_down = action != GLFW_RELEASE;
    if (action != GLFW_REPEAT) events.keys[key] = action == GLFW_PRESS;
    if (action == GLFW_PRESS) events.pressed.push_back(key);
    if (action == GLFW_REPEAT) events.held.push_back(key);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) { changed(w).typed += static_cast<char32_t>(code); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { changed(w); });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { changed(w); });
}

/// GLFW reports the mouse in units of the window; a HiDPI display has more pixels than units.
Vec2 Window::to_pixels(double x, double y) const {
  int w = 1, h = 1;
  glfwGetWindowSize(window_, &w, &h);
  const auto [width, height] = size();
  return {static_cast<float>(x * width / std::max(w, 1)), static_cast<float>(y * height / std::max(h, 1))};
}

bool Window::is_to_close() const { return glfwWindowShouldClose(window_) != 0; }

const WindowEvents& Window::poll(double seconds) {
  events_ = {.mouse = events_.mouse,
             .is_mouse_down = events_.is_mouse_down,
             .is_shift_down = events_.is_shift_down,
             .is_ctrl_down = events_.is_ctrl_down};
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
  return events_;
}

PictureSize Window::size() const {
  PictureSize size{0, 0};
  glfwGetFramebufferSize(window_, &size.width, &size.height);
  return size;
}
float Window::density() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return std::max(y, 1.0f);
}
void Window::show() { glfwSwapBuffers(window_); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

bool Window::is_full_screen() const { return glfwGetWindowMonitor(window_) != nullptr; }

void Window::set_full_screen(bool is_full) {
  if (is_full == is_full_screen()) return;
  auto& [x, y, width, height] = before_;
  if (!is_full) return glfwSetWindowMonitor(window_, nullptr, x, y, width, height, GLFW_DONT_CARE);
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (!mode) return;
  glfwGetWindowPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace ballpit
