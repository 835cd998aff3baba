// SPDX-License-Identifier: MIT
#include "window/scene_window.h"

#include <algorithm>
#include <thread>

#include <GLFW/glfw3.h>

#include "core/interrupt.h"

namespace ballpit {

namespace {

constexpr double kIdle = 0.25;  // [s] to wait for an event while nothing moves
constexpr float kClick = 4;     // [pixel] largest movement of the mouse in a click
const Vec2 kNowhere(9);         // a place outside of the picture

double seconds_between(std::chrono::steady_clock::time_point a, std::chrono::steady_clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

void sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

}  // namespace

void SceneWindow::run() {
  auto last = Clock::now();
  while (!window.is_to_close() && !was_interrupted() && !is_stopped_) {
    const bool is_idle =
        drawn_ == demo().version() && !demo().player.is_running && !is_settling_ && !is_busy() && !is_fading();
    const WindowEvents& events = window.poll(is_idle ? kIdle : 0);
    const auto now = Clock::now();
    const double elapsed = seconds_between(last, now);
    last = now;
    handle(events);
    demo().player.observe(elapsed);
    advance(std::min(elapsed, kIdle));  // no great leap after a long frame
    if (const PictureSize size = window.size(); size.width < 16 || size.height < 16) {  // minimised
      sleep(kFrame);
      continue;
    }
    if (events.any || drawn_ != demo().version() || is_settling_ || is_fading()) {
      const Demo::Version version = demo().version();
      draw(events, static_cast<float>(elapsed));
      is_settling_ = drawn_ != version || events.any;  // a panel shows the outcome of a click a frame later
      drawn_ = version;
    }
    if (seconds_between(titled_, now) >= 1) {
      titled_ = now;
      window.set_title(title());
    }
    const double left = kFrame - seconds_between(now, Clock::now());
    if ((demo().player.is_running || is_fading()) && left > 0) sleep(left);
  }
}

bool SceneWindow::goes_on(int code) const { return code == GLFW_KEY_RIGHT || code == GLFW_KEY_LEFT; }

void SceneWindow::handle(const WindowEvents& events) {
  is_shift_down_ = events.is_shift_down;
  is_ctrl_down_ = events.is_ctrl_down;
  if (!takes_keyboard()) {
    for (const int code : events.pressed) press(code);
    for (const int code : events.held) {
      if (goes_on(code)) press(code);
    }
  }
  if (events.was_pressed) {
    pressed_at_ = events.mouse;
    is_grabbing_ = !takes_mouse() && grab(events.mouse);
    is_turning_ = !takes_mouse() && !is_grabbing_;
  }
  const bool is_click = length(events.mouse - pressed_at_) <= kClick;
  if (is_grabbing_ && events.mouse != mouse_) drag(events.mouse);
  if (is_grabbing_ && events.was_released) let_go(events.mouse, is_click);
  if (is_turning_ && events.is_mouse_down && events.mouse != mouse_) {
    const Vec2 moved = (events.mouse - mouse_) / static_cast<float>(std::max(window.size().height, 1));
    demo().view.orbit(moved.x, moved.y);
    demo().touch();
  }
  if (events.was_released && is_turning_ && is_click) click(events.mouse);
  if (events.was_released) is_turning_ = is_grabbing_ = false;
  if (events.wheel != 0 && !takes_mouse()) {
    demo().view.zoom_by(events.wheel);
    demo().touch();
  }
  if (events.has_menu) {
    toggle_panel();
    demo().touch();
  }
  mouse_ = events.mouse;
}

SceneWindow::Seen SceneWindow::seen_at(Vec2 at) {
  const PictureSize size = window.size();
  const auto margin = static_cast<float>(left()), height = static_cast<float>(size.height);
  const float width = static_cast<float>(size.width) - margin;
  const Vec2 place((at.x - margin) / width, at.y / height);
  const std::vector<Room> rooms = demo().rooms(width / height);
  for (size_t k = 0; k < rooms.size() && demo().is_comparing(); ++k) {
    const Room& room = rooms[k];
    const Vec2 inside = (place - Vec2(room.left, room.above)) / Vec2(room.width(), room.height());
    if (inside != glm::clamp(inside, Vec2(0), Vec2(1))) continue;  // in another view
    const float aspect = width / height * room.width() / room.height();
    return {demo().view_at(k).frame_view(aspect, false, false, room.height()), {2 * inside.x - 1, 1 - 2 * inside.y}};
  }
  if (demo().is_comparing()) return {demo().view_at(0).frame_view(1), kNowhere};
  return {frame_view(width / height), {2 * place.x - 1, 1 - 2 * place.y}};
}

void SceneWindow::pick(Vec2 at) {
  const auto [view, place] = seen_at(at);
  demo().view.selected = body_at(view.camera, view.inspection.bodies, place);
  demo().touch();
}

}  // namespace ballpit
