// SPDX-License-Identifier: MIT
#include "window/show_window.h"

#include <array>

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "core/numbers.h"
#include "core/phrase.h"

namespace ballpit {

std::span<const WindowKey> window_keys() {
  static constexpr std::array kKeys{
      WindowKey{GLFW_KEY_S, "S", "save a picture", [](ShowWindow& w) { w.save_picture(); }},
      WindowKey{GLFW_KEY_F11, "F11", "full screen", [](ShowWindow& w) { w.toggle_full_screen(); }},
      WindowKey{GLFW_KEY_F, "F", "full screen", [](ShowWindow& w) { w.toggle_full_screen(); }},
      WindowKey{GLFW_KEY_RIGHT, "→", "step through the slide's kernel, with Shift by phases",
                [](ShowWindow& w) { w.move_cursor(1); }},
      WindowKey{GLFW_KEY_LEFT, "←", "the same, back", [](ShowWindow& w) { w.move_cursor(-1); }},
      WindowKey{GLFW_KEY_ESCAPE, "Esc", "leave the kernel, then full screen", [](ShowWindow& w) { w.leave(); }},
      WindowKey{GLFW_KEY_TAB, "Tab", "hide the panel, or show it", [](ShowWindow& w) { w.toggle_panel(); }},
  };
  return kKeys;
}

std::span<const std::string_view> hand_gestures() {
  static constexpr std::array<std::string_view, 3> kGestures{
      "Shift + drag: throw a sphere", "Ctrl + drag: push a handful of spheres", "Shift + click: drop a sphere in"};
  return kGestures;
}

ShowWindow::ShowWindow(Window& its_window, Demo& demo)
    : SceneWindow(its_window),
      demo_(demo),
      drawing_(window.size().width, window.size().height, {}),
      panel_(drawing_.renderer().sheet()),
      saver_(demo),
      stepping_(demo),
      hand_(demo) {
  demo_.session.time_stages(true);  // the panel shows them
  for (const Key& key : key_table()) panel_.keys.push_back({std::string(key.name), std::string(key.help)});
  for (const WindowKey& key : window_keys()) panel_.keys.push_back({std::string(key.name), std::string(key.help)});
  for (const std::string_view gesture : hand_gestures()) panel_.gestures.emplace_back(gesture);
  demo_.player.is_running = false;  // until somebody looks
  panel_.hint(translated("Space: play     click: pick a sphere     Shift + drag: throw it     F1: all keys"));
}

void ShowWindow::leave() {
  if (hand_.is_aiming()) return hand_.cancel();
  stepping_.cursor() ? stepping_.end() : window.set_full_screen(false);
}

/// Time stands still while the hand aims.
void ShowWindow::advance(double elapsed) {
  if (saver_.is_filming()) {
    saver_.advance();
  } else if (!hand_.is_aiming()) {
    SceneWindow::advance(elapsed);
  }
}

/// Says why not.
bool ShowWindow::can_act() {
  if (stepping_.cursor()) {
    demo_.say(translated("leave the kernel first, with Esc"));
  } else if (saver_.is_filming()) {
    demo_.say(translated("wait for the end of the film"));
  } else {
    return true;
  }
  demo_.touch();
  return false;
}

bool ShowWindow::grab(Vec2 at) {
  if (is_shift_down() == is_ctrl_down() || !can_act()) return false;
  const auto [view, place] = seen_at(at);
  return hand_.grab(view, place, is_shift_down() ? ActKind::to_throw : ActKind::push);
}

void ShowWindow::let_go(Vec2 at, bool is_click) {
  if (!hand_.is_aiming()) return;  // Esc has cancelled it
  if (!is_click) return hand_.release();
  hand_.cancel();
  click(at);
}

void ShowWindow::click(Vec2 at) {
  if (!is_shift_down()) return pick(at);
  if (!can_act()) return;
  const auto [view, place] = seen_at(at);
  hand_.drop(view, place);
}

void ShowWindow::move_cursor(int direction) {
  if (demo_.is_comparing()) return demo_.say("no kernel is stepped while broad phases are compared");
  is_shift_down() ? stepping_.skip_phase(direction) : stepping_.move(direction);
}

bool ShowWindow::goes_on(int code) const {
  return code == GLFW_KEY_PERIOD || code == GLFW_KEY_COMMA || SceneWindow::goes_on(code);
}

void ShowWindow::press(int code) {
  panel_.end_hint();
  for (const Key& key : key_table()) {
    if (key.code == code) demo_.perform(key);
  }
  for (const WindowKey& key : window_keys()) {
    if (key.code == code) key.act(*this);
  }
  if (demo_.shows_keys) panel_.is_shown = true;
  demo_.touch();
}

void ShowWindow::draw(const WindowEvents& events, float elapsed) {
  Renderer& renderer = drawing_.renderer();
  const auto [width, height] = window.size();
  if (renderer.width() != width || renderer.height() != height) renderer.resize(width, height);
  if (stepping_.cursor()) {
    renderer.set_options({.theme = theme_named(demo_.view.theme), .left = left(), .text_scale = demo_.view.text_scale});
    renderer.draw(stepping_.frame_view(static_cast<float>(width - left()) / static_cast<float>(height)));
  } else {
    drawing_.draw(demo_, {.left = left()});
  }
  panel_.density = window.density();
  panel_.top = stepping_.cursor() || demo_.view.has_caption ? room_of(PageView{}, demo_.view.text_scale, 1).above : 0;
  panel_.is_filming = saver_.is_filming();
  panel_.shows_card = !demo_.is_comparing();  // it would cover a view
  if (events.was_released) panel_.end_hint();
  panel_.draw(demo_, events.for_panel(elapsed));
  renderer.copy_to_window();
  window.show();
  handle(panel_.requests);
}

void ShowWindow::handle(PanelRequests& requests) {
  if (requests.picture) save_picture();
  if (requests.state) saver_.save_state();
  if (requests.acts) saver_.save_acts();
  if (requests.film && saver_.is_filming()) {
    saver_.stop_film();
  } else if (requests.film) {
    saver_.start_film(parse_size(requests.film_size), requests.film_frames);
  }
  requests.picture = requests.state = requests.acts = requests.film = false;
}

/// As the exercise sheet asks: spheres, method, milliseconds a step.
std::string ShowWindow::title() {
  const Report& report = demo_.report();
  if (demo_.is_comparing()) {
    return phrase("Ballpit: {} spheres, {}", grouped(report.count), join(demo_.compared_methods()));
  }
  return phrase("Ballpit: {} spheres, {}, {} ms a step", grouped(report.count), report.broadphase,
                local_number(three_digits(demo_.player.mean_step_time())));
}

}  // namespace ballpit
